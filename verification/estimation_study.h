#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/cable/property_variation.h"
#include "verification/navigation_study.h"

namespace tether_monitor::bench
{
/// A case whose tether, water and vehicle are not known well.
struct UncertainCase
{
  Case of;
  bool is_towed =
      true;  ///< else a vehicle under its own thrust, which is not reported, keeps to a place or a way.
  double manoeuvre = 0.0;             ///< speed of that way [m/s].
  double force_stddev = 165.0;        ///< told of the unknown force [N].
  monitor::UncertaintyConfig told;    ///< what is told to the estimator, and what truths are drawn from.
  double vehicle_drag_stddev = 0.15;  ///< likewise [-].
  int true_elements = 50;
  core::Vector3 current_change = core::Vector3::Zero();  ///< of the true current, in ten seconds [m/s].
  double changes_at = 0.0;                               ///< [s]
  core::Vector3 run_off = core::Vector3::Zero();  ///< velocity of a vehicle that leaves its station then [m/s].
  double most_thrust = 1e9;                       ///< of a vehicle under its own thrust [N].
};

/// C (tow in heave), D (tow in a turn), G (keeps its station in a current), R (rests), M (manoeuvres at 0.5 m/s),
/// S (slack tether in a sheared current).
std::vector<UncertainCase> uncertainCases();
/// C and G in a current that changes by 0.3 m/s after 200 s, scored from five minutes after that on.
std::vector<UncertainCase> changingCurrents();

/// What is otherwise in a truth than was told.
struct TruthDraw
{
  core::PropertyVariation variation;
  core::Vector3 force = core::Vector3::Zero();  ///< on a towed vehicle [N].
  double tension_bias = 0.0;                    ///< of the load cell, in standard deviations.
};

/// Drawn from what is told.
TruthDraw drawTruth(const UncertainCase& c, unsigned seed);
/// Moves a case with what is otherwise in it.
Truth makeTruth(const UncertainCase& c, const TruthDraw& draw);

/// C, D, G, ... by name. @throws std::out_of_range
UncertainCase uncertainCase(const std::string& name);

/// Configuration for a truth of a case.
monitor::Config configFor(const UncertainCase& c, const Truth& truth, const Sensors& sensors);

/// How good many runs are together: pooled over truths and times.
struct PooledScore
{
  long samples = 0;
  double rms = 0.0, mean = 0.0, band = 0.0;  ///< RMS error, mean and mean standard deviation of a tension [N].
  double nees = 0.0;                         ///< mean square of error over standard deviation.
  double within_1 = 0.0, within_90 = 0.0;  ///< shares within one standard deviation, and in the 5..95 % quantiles.
};

/// What pooled runs of one case give.
struct StudyResult
{
  PooledScore vessel, vehicle;
  double position_rms = 0.0, position_within_2 = 0.0;                   ///< [m], share
  double within_2 = 0.0;                                                ///< of the vessel tension.
  double ok = 0.0, valid = 0.0, implausible = 0.0, disagreement = 0.0;  ///< shares of the time.
  double sure_and_wrong = 0.0;  ///< longest time OK, more than 10 % off and outside two standard deviations [s].
  int limit_alarms = 0;         ///< runs in which the limit alarm rose, though the truth stays below the limit.
  double hours = 0.0;           ///< simulated.
  int runs = 0;
  double cpu = 0.0;                             ///< [s] a simulated second.
  std::vector<double> vessel_rms, vehicle_rms;  ///< of every run, over its mean.
};

struct StudyOptions
{
  int draws = 32;
  unsigned first_seed = 1000;
  double latency = 0.0;
  bool has_load_cell = false;
  int elements = 10;
  double rate = 10.0;  ///< [Hz]
  int threads = 2;
  /// What the estimator is told wrong of a truth that is as told otherwise; none: truths are drawn.
  std::function<void(monitor::Config&)> mislead = nullptr;
};
StudyResult studyPooled(const UncertainCase& c, const StudyOptions& options);

/// One thing that is configured wrong in a tow.
struct Misconfiguration
{
  std::string what;
  std::function<void(monitor::Config&)> mislead;
};
/// Those of doc/theory/estimation.md.
std::vector<Misconfiguration> misconfigurations();

}  // namespace tether_monitor::bench
