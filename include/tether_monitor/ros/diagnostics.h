#pragma once

#include <diagnostic_updater/diagnostic_updater.h>

#include <map>
#include <string>

#include "tether_monitor/monitor/estimate/vibration_report.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/input_statistics.h"
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
  long ticks = 0;
  long missed = 0;                     ///< cycles that should have been and were not.
  bool clock_stands = false;           ///< time has not gone on since the last update.
  bool master_is_lost = false;         ///< the ROS master does not answer.
  monitor::VibrationReport vibration;  ///< of the last update.
  int forecast_members = 0;            ///< that a forecast can afford now; 0: there is none.
  double forecast_interval = 0.0;      ///< [s] from one to the next.
  bool forecast_is_short = false;      ///< the machine is too slow for what is configured.
};

/// Fills a status with level, summary, numbers, likely cause and advice.
void diagnose(const monitor::TetherEstimator& estimator, const DiagnosticInputs& inputs,
              diagnostic_updater::DiagnosticStatusWrapper& status);

/// Fills a status with natural frequencies and what excites them; WARN on resonance with the waves or strumming.
void diagnoseVibration(const monitor::VibrationReport& report,
                       diagnostic_updater::DiagnosticStatusWrapper& status);

}  // namespace tether_monitor
