#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <limits>
#include <map>
#include <string>

#include "tether_monitor/monitor/estimate/vibration_report.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/cycle_statistics.h"
#include "tether_monitor/ros/input_statistics.h"
#include "tether_monitor/ros/publishing_report.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// Messages refused on one topic.
struct RefusalCount
{
  long count = 0;
  std::string last_reason;
};

/// What the diagnostics need besides the estimator.
struct DiagnosticInputs
{
  std::map<std::string, RefusalCount> refusals;       ///< by topic.
  std::map<std::string, RefusalCount> failures;       ///< caught exceptions, by what was done.
  std::map<std::string, InputStatistics> statistics;  ///< by topic.
  TimeOrigin time;                                    ///< of the estimator's seconds.
  double worst_step_time = 0.0;                       ///< [s] since the start.
  long lost_messages = 0;                             ///< for want of room between two cycles.
  std::string realtime_refusal;        ///< what the machine refused of monitor.realtime; empty: nothing.
  std::string state_file_problem;      ///< empty: none.
  bool clock_stands = false;           ///< time has not gone on since the last update.
  bool master_is_lost = false;         ///< the ROS master does not answer.
  monitor::VibrationReport vibration;  ///< of the last update.
  int forecast_members = 0;            ///< that a forecast can afford now; 0: there is none.
  double forecast_interval = 0.0;      ///< [s] from one to the next.
  bool forecast_is_short = false;      ///< the machine is too slow for what is configured.
  double forecast_probability = std::numeric_limits<double>::quiet_NaN();  ///< of over-tension, of the last one.
};

/// Fills a status with level, summary, numbers, likely cause and advice.
void diagnose(const monitor::TetherEstimator& estimator, const DiagnosticInputs& inputs,
              diagnostic_updater::DiagnosticStatusWrapper& status);

/// Fills a status with how punctual cycles and outputs are; WARN when more than one cycle in twenty is late.
void diagnoseTiming(const DiagnosticInputs& inputs, const CycleStatistics& cycles,
                    const PublishingReport& publishing, diagnostic_updater::DiagnosticStatusWrapper& status);

/// How near the waves' frequency is to a natural one, 1: the same; NaN: not known, or there are no waves.
double nearnessOfResonance(const monitor::VibrationReport& report);

/// Fills a status with natural frequencies and what excites them; WARN on resonance with the waves or strumming.
void diagnoseVibration(const monitor::VibrationReport& report,
                       diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace tether_monitor
