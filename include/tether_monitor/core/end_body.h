#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/environment.h"
#include "tether_monitor/core/types.h"

namespace tether_monitor::core
{
/// Constants of a simulated body at the vehicle end. Vectors are along its axes (x forward, y left, z up).
struct EndBody
{
  double mass = 0.0;                  ///< [kg], > 0.
  double volume = 0.0;                ///< displaced [m^3], >= 0.
  Vector3 inertia = Vector3::Zero();  ///< [kg m^2] about the centre of mass, each > 0.
  Vector3 drag_area =
      Vector3::Zero();  ///< CdA [m^2], each >= 0: F_i = -1/2 rho CdA_i |v| v_i, v relative to the water.
  Vector3 force = Vector3::Zero();  ///< [N], constant, world frame, at the centre of mass.
};

/// Every bound of EndBody that `body` violates, one sentence each, beginning with "vehicle.".
std::vector<std::string> problems(const EndBody& body);

/**
 * Force of weight, buoyancy, drag and the constant force on a level body that moves steadily, (M19) of
 * doc/model.md.
 *
 * @param position  of the body [m]; above the surface there is neither buoyancy nor drag.
 * @param velocity  of the body [m/s], world frame; the body's axes are those of the world.
 * @return          [N], world frame.
 */
Vector3 steadyForce(const EndBody& body, const Environment& sea, const Vector3& position, const Vector3& velocity);

}  // namespace tether_monitor::core
