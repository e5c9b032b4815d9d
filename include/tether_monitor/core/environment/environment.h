#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/environment/current_profile.h"
#include "tether_monitor/core/environment/obstacle.h"
#include "tether_monitor/core/environment/sea_state.h"
#include "tether_monitor/core/environment/seabed.h"

namespace tether_monitor::core
{
/// The sea around the tether, as a user describes it. The still water surface is z = 0.
struct Environment
{
  double water_density = 1025.0;   ///< rho [kg/m^3], >= 0 (zero: the tether hangs in air).
  double gravity = 9.81;           ///< g [m/s^2], >= 0.
  CurrentProfile current;          ///< WaterKinematics velocity by depth; default still water.
  SeaState waves;                  ///< default none.
  Vector3 wind = Vector3::Zero();  ///< velocity of the air [m/s]; zero: the air is not felt at all.
  std::optional<Seabed> seabed;    ///< default none.
  std::vector<Obstacle> obstacles;
};

/// Every bound of Environment that `environment` violates, one sentence each.
std::vector<std::string> validate(const Environment& environment);

}  // namespace tether_monitor::core
