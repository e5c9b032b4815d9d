#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/current_profile.h"
#include "tether_monitor/core/types.h"

namespace tether_monitor::core
{
/// The sea around the tether. The still water surface is z = 0.
struct Environment
{
  double water_density = 1025.0;  ///< rho [kg/m^3], >= 0 (zero: the tether hangs in air).
  double gravity = 9.81;          ///< g [m/s^2], >= 0.
  CurrentProfile current;         ///< Water velocity by depth; default still water.

  /// Velocity of the water [m/s] at a point of the world [m].
  Vector3 waterVelocity(const Vector3& point) const { return current.at(point.z()); }
};

/// Every bound of Environment that `environment` violates, one sentence each.
std::vector<std::string> problems(const Environment& environment);

}  // namespace tether_monitor::core
