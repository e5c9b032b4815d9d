#pragma once

#include <array>
#include <vector>

#include "tether_monitor/monitor/forecast/tether_forecast.h"

namespace tether_monitor::monitor
{
/**
 * How good forecasts of over-tension were, against what came: (F4) of doc/theory/forecast.md.
 *
 * A forecast counts if the estimate is not past the limit when it is made (then the alarm has come) and if what
 * came is known to the end of its horizon. Whether the tether is past it at that time must not matter: nobody
 * knows. An event begins when the limit is passed after at least ten seconds below it.
 */
class ForecastScore
{
 public:
  /// One class of forecast probabilities.
  struct Reliability
  {
    double least = 0.0, most = 0.0;  ///< probabilities of the class.
    long forecasts = 0;
    double mean_probability = 0.0;  ///< of these [-].
    double observed = 0.0;          ///< share of them that came true [-].
  };
  /// What comes of warning from a probability on.
  struct Warnings
  {
    double probability = 0.0;                        ///< that a warning takes, at least.
    long warned = 0;                                 ///< events with one (or the alarm) ten seconds or more ahead.
    double median_lead_time = TetherForecast::NONE;  ///< from the first such forecast to the event [s].
    long warnings = 0;                               ///< spells of such forecasts, ten seconds or more apart.
    long false_warnings = 0;  ///< of these, where nothing came within a horizon of their end, or of the record.
  };
  struct Result
  {
    std::vector<Reliability> reliability;
    double brier_score = 0.0;  ///< mean square of probability less outcome; 0 is perfect.
    long events = 0;
    std::vector<Warnings> warnings;  ///< from probabilities of 0.5, 0.8, 0.95 on.
  };

  /// Whether the tether is past the limit at time t [s]; in order of time.
  void observe(double t, bool is_over);
  /// A forecast made at the time of the last observation, and whether the estimate is past the limit then.
  /// Forecasts without members do not count.
  void add(const TetherForecast& forecast, bool is_estimate_over);
  /// Takes in the sums of another record.
  void add(const ForecastScore& other);
  Result result() const;

 private:
  struct Made
  {
    double t, horizon, probability;
    bool was_over, was_estimate_over;
  };

  struct WarningSums
  {
    long warned = 0, warnings = 0, false_warnings = 0;
    std::vector<double> lead;
  };
  struct Sums
  {
    std::array<long, 7> forecasts{}, came_true{};
    std::array<double, 7> probability{};
    double square = 0.0;
    long events = 0;
    std::array<WarningSums, 3> warnings;
  };
  double nextOver(double t) const;
  void countForecasts(Sums& sums) const;
  /// Spells of warnings, and which of them were false.
  void countWarnings(double probability, WarningSums& sums) const;
  /// True if there was a forecast ten seconds or more ahead: else an event is none to be warned of.
  bool couldBeKnown(double onset) const;
  double leadTime(double onset, double probability) const;
  Sums evaluate() const;

  std::vector<Made> made_;
  std::vector<double> onsets_;      // of events [s]
  std::vector<double> over_times_;  // at which the tether was past the limit [s]
  double now_ = 0.0, last_over_ = -1e300;
  bool is_over_ = false;
  std::vector<Sums> others_;
};

}  // namespace tether_monitor::monitor
