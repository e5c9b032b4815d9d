#pragma once

#include "tether_monitor/core/environment/obstacle.h"

namespace tether_monitor::core
{
inline Obstacle ball(double radius, const Vector3& at)
{
  Obstacle obstacle;
  obstacle.size[0] = radius;
  obstacle.position = at;
  return obstacle;
}
}  // namespace tether_monitor::core
