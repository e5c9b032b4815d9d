#pragma once

#include <limits>

namespace tether_monitor::monitor
{
/// What alarms watch beside the estimate; NaN: not known.
struct AlarmInputs
{
  static constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

  double tension_rate = NONE;  ///< how fast the largest tension rises [N/s].
  double lay_back = NONE;      ///< horizontal distance from the vessel end to the vehicle end [m].
  double scope = NONE;         ///< deployed length over the depth of the vehicle end below the vessel end [-].
  double touchdown_distance = NONE;  ///< horizontal, from the vessel end to the first point on the seabed [m].
  double turns = NONE;               ///< of the tether, signed, counter-clockwise from above.
  double clearance = NONE;           ///< least distance from the tether's surface to an obstacle [m]; < 0: inside.
  double clearance_s = NONE;         ///< where [m].
  double obstacle_force = NONE;      ///< largest sum of normal forces on an obstacle [N].
  double obstacle_force_s = NONE;    ///< where [m].
  double mismatch = NONE;            ///< load cell less predicted, over its standard deviation, size [-].
  double mismatch_s = NONE;          ///< where the tether is held fast, if that explains it [m].
  double lock_in = NONE;             ///< share of the tether that strums in one mode [-].
  // What only the one who runs the estimator knows:
  double forecast_probability = NONE;  ///< of over-tension within the horizon [-].
  double resonance = NONE;             ///< nearness of the waves' frequency to a natural one, 1: the same [-].
  double missed_cycles = NONE;         ///< share of the cycles of the last seconds that were missed or late [-].
};

}  // namespace tether_monitor::monitor
