#pragma once

#include "tether_monitor/core/base/tangent_weights.h"
#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/environment/environment_model.h"

namespace tether_monitor::core
{
/// How a body moves: the point where the tether is fixed to it, world frame, and its attitude.
struct RigidBodyMotion
{
  double time = 0.0;  ///< [s], for the waves.
  Vector3 position = Vector3::Zero(), velocity = Vector3::Zero(), acceleration = Vector3::Zero();
  AttitudeState attitude;
  PropertyVariation variation = {};  ///< of the water and of the body's drag.
};

/// Motion of a body that is fixed to a node of a state.
RigidBodyMotion rigidBodyMotion(const CableState& state, std::size_t node, const AttitudeState& attitude);

/**
 * What a body asks of the node that it is fixed to.
 *
 * `force` is the force that the node must receive from outside for the body's sake [N]; `moment` that about the
 * centre of mass, body axes [N m]: zero when the equations of rotation hold. The blocks are weighted derivatives
 * with respect to the node's position (n) and to a rotation in body axes (r).
 */
struct RigidBodyResidual
{
  Vector3 force, moment;
  Matrix3 force_n, force_r, moment_n, moment_r;
};

/**
 * Equations of motion of a rigid body that hangs on a node: Newton, Euler and Kirchhoff, (M19) of doc/model.md;
 * paper 28-33.
 *
 * @param thrust  at the centre of mass.
 */
RigidBodyResidual rigidBodyResidual(const RigidBody& body, const EnvironmentModel& environment,
                                    const RigidBodyMotion& motion, const Wrench& thrust,
                                    const TangentWeights& weights);

/// Force of weight, buoyancy, drag and the constant force on a body that moves steadily with its axes those of the
/// world [N]. @param attachment  position of the tether's end [m]; an environment without waves.
Vector3 steadyForce(const RigidBody& body, const EnvironmentModel& environment, const Vector3& attachment,
                    const Vector3& velocity);

/// Drag of the water on a body in motion [N], world axes.
Vector3 bodyDrag(const RigidBody& body, const EnvironmentModel& environment, const RigidBodyMotion& motion);

/// Centre of mass of a body [m] whose attachment is at `attachment`.
Vector3 centreOfMass(const RigidBody& body, const Vector3& attachment, const AttitudeState& attitude);

}  // namespace tether_monitor::core
