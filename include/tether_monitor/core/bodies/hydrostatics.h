#pragma once

#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/environment/environment_model.h"

namespace tether_monitor::core
{
/// Buoyancy of a body: force along z of the world and its moment about the centre of mass, world axes, with their
/// derivatives.
struct Hydrostatics
{
  double force = 0.0;                         ///< [N], >= 0.
  Vector3 moment = Vector3::Zero();           ///< [N m]
  double submerged_fraction = 0.0;            ///< of the body [-].
  double submerged_volume = 0.0;              ///< [m^3]
  double heave_stiffness = 0.0;               ///< -d force / dz [N/m].
  Vector3 force_rotation = Vector3::Zero();   ///< d force / d rotation, world axes [N].
  Vector3 moment_heave = Vector3::Zero();     ///< d moment / dz [N].
  Matrix3 moment_rotation = Matrix3::Zero();  ///< d moment / d rotation, world axes [N m].
};

/**
 * Buoyancy of a hull in columns that follow the waves, or of a volume that is submerged as a ball of its size
 * would be; (M19) of doc/model.md.
 *
 * @param t       [s], for the waves.
 * @param water   at the centre of mass.
 * @param centre  centre of mass, model coordinates [m].
 * @param R       body to world.
 */
Hydrostatics hydrostatics(const RigidBody& body, const EnvironmentModel& environment, double t,
                          const WaterKinematics& water, const Vector3& centre, const Matrix3& R);

}  // namespace tether_monitor::core
