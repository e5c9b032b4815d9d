#pragma once

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/cable/deployment.h"
#include "tether_monitor/core/cable/end_clamps.h"

namespace tether_monitor::core
{
/// Ends between which a steady state is wanted: both move with the same constant velocity. The vehicle end is
/// held, or free if the model has a body there, which then finds its own position, its axes those of the world.
struct SteadyEnds
{
  Vector3 vessel = Vector3::Zero();    ///< position of the vessel end [m].
  Vector3 vehicle = Vector3::Zero();   ///< position of the vehicle end [m].
  Vector3 velocity = Vector3::Zero();  ///< common velocity [m/s].
  Deployment deployment = {};          ///< of the tether, at rest: a rate of its length does not count.
  EndClamps clamps = {};
};

/// Speed of the ends below which a tether lies still and friction holds it [m/s].
constexpr double STANDSTILL = 1e-3;

}  // namespace tether_monitor::core
