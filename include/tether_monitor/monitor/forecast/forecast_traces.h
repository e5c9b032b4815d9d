#pragma once

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <vector>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/forecast/tether_forecast.h"

namespace tether_monitor::monitor
{
/// What a forecast compares with: those of the alarms.
struct ForecastLimits
{
  explicit ForecastLimits(const Config& config);

  std::optional<double> warning, limit;  ///< of over_tension, over the working load [-].
  std::optional<double> breaking;        ///< over the breaking load [-].
  double slack = 0.0;                    ///< [N]
};

/// What the members of a forecast go through: a row for each time, a column for each member.
class ForecastTraces
{
 public:
  /// @param interval  between times [s], > 0.
  void begin(int members, double horizon, double interval);
  /// Notes a member's tether at `after` [s] from the beginning; in order of time for each member.
  void add(int member, double after, const TetherEstimate& e, const ForecastLimits& limits);
  /// Notes where a member's tether is at the end. @param stations  world [m].
  void finish(int member, std::vector<core::Vector3> stations) { last_[member] = std::move(stations); }
  /// Leaves a member out, whose tether could not be stepped.
  void drop(int member) { alive_[member] = 0; }
  /// True if the member has come to the limit of over-tension.
  bool passesLimit(int member) const { return std::isfinite(to_limit_[member]); }
  int alive() const { return static_cast<int>(alive_.count()); }
  /// Share of the members that pass the limit of over-tension within the horizon.
  double probabilityOfOverTension() const;
  /// Fills in all but t and what is recommended; at least two members must be alive.
  void summarize(TetherForecast& forecast) const;

 private:
  using Table = Eigen::ArrayXXd;
  using Row = Eigen::ArrayXd;

  double horizon_ = 0.0, interval_ = 1.0;
  Table largest_, least_, vessel_, vehicle_;
  Eigen::Array<bool, Eigen::Dynamic, 1> alive_, breaks_;
  Row to_warning_, to_limit_, to_slack_;  // [s]; infinite: never
  Row peak_, place_;                      // largest tension [N] and where [m]
  std::vector<std::vector<core::Vector3>> last_;
};

}  // namespace tether_monitor::monitor
