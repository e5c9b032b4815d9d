#pragma once

#include <limits>
#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::monitor
{
/// The next seconds of a tether: medians and quantiles over its members, (F2) of doc/theory/forecast.md. Vectors
/// have an entry for each time; probabilities and times are those within the horizon.
struct TetherForecast
{
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  double t = 0.0;        ///< when it begins [s].
  double horizon = 0.0;  ///< [s]
  int members = 0;       ///< tethers it rests on; 0: there is no forecast.
  bool from_plan = false;
  double computing_time = 0.0;  ///< [s] of one core.

  std::vector<double> time;                                           ///< from t on [s].
  std::vector<double> max_tension, max_tension_p05, max_tension_p95;  ///< largest along the tether since the time
                                                                      ///< before [N].
  std::vector<double> vessel_tension, vehicle_tension;                ///< at that time, medians [N].
  std::vector<double> min_tension;                                    ///< median of the least along it [N].

  double probability_over_tension = NONE;  ///< share of the members that pass the limit of over_tension.
  double probability_breaking = NONE;      ///< that of breaking.
  double probability_slack = NONE;         ///< that of slack; where none is configured, of no pull at all.
  /// Medians over the members that get there [s from t]; NaN if under half of them do.
  double time_to_warning = NONE, time_to_limit = NONE, time_to_slack = NONE;
  double time_to_limit_p05 = NONE;  ///< time by which one in twenty is at the limit [s]; NaN if fewer ever are.
  double place_s = NONE;            ///< where along the tether the largest tension of a median member is [m].
  std::vector<core::Vector3> position;  ///< stations of that member's tether at the end of the horizon, world [m].

  double recommended_vessel_speed =
      NONE;  ///< largest along the present way with which P(over-tension) < 5 % [m/s].
  double recommended_payout_rate = NONE;  ///< least with which it is [m/s].
};

}  // namespace tether_monitor::monitor
