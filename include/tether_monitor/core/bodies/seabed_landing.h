#pragma once

#include "tether_monitor/core/base/tangent_weights.h"
#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/environment/environment_model.h"

namespace tether_monitor::core
{
/// Force of the seabed on a body and its weighted stiffness -d force / d position, world axes.
struct SeabedReaction
{
  Vector3 force = Vector3::Zero();      ///< [N]
  Matrix3 stiffness = Matrix3::Zero();  ///< [N/m], see TangentWeights.
};

/// The seabed under a body, as under a ball of its volume: a spring with a damper that begins softly, and
/// friction; (M19) of doc/model.md. Zero without a seabed, for a hull, and without contact.
/// @param centre, velocity  of the centre of mass [m, m/s].
SeabedReaction seabedReaction(const RigidBody& body, const EnvironmentModel& environment, const Vector3& centre,
                              const Vector3& velocity, const TangentWeights& weights);

}  // namespace tether_monitor::core
