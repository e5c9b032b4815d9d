#pragma once

#include <string>
#include <vector>

#include "verification/estimation_truths.h"

namespace tether_monitor::bench
{
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
