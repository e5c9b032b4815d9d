#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/assembly/element_equations.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/environment/environment_model.h"

namespace tether_monitor::core
{
/// A box-shaped hull that pierces the surface; its buoyancy follows the waves. Axes of the body.
struct Hull
{
  Vector3 size = Vector3::Zero();  ///< length, beam, height [m], each > 0.
  Vector3 keel = Vector3::Zero();  ///< centre of the bottom, from the centre of mass [m].
};

/// Constants of a simulated rigid body at a tether end. Vectors are along its axes (x forward, y left, z up).
struct RigidBody
{
  double mass = 0.0;                        ///< [kg], > 0.
  double volume = 0.0;                      ///< displaced [m^3], >= 0; not used with a hull.
  Vector3 inertia = Vector3::Zero();        ///< [kg m^2] about the centre of mass, each > 0.
  Vector3 drag_area = Vector3::Zero();      ///< CdA [m^2], each >= 0: F_i = -1/2 rho CdA_i |v| v_i, v relative to
                                            ///< the water.
  Vector3 added_mass = Vector3::Zero();     ///< [kg], each >= 0.
  Vector3 added_inertia = Vector3::Zero();  ///< [kg m^2], each >= 0.
  Vector3 rotational_drag = Vector3::Zero();     ///< c [N m s^2], each >= 0: M_i = -c_i |w| w_i.
  Vector3 center_of_buoyancy = Vector3::Zero();  ///< from the centre of mass [m].
  Vector3 force = Vector3::Zero();               ///< [N], constant, world frame, at the centre of mass.
  Vector3 attachment = Vector3::Zero();          ///< of the tether, from the centre of mass [m].
  Vector3 wind_area = Vector3::Zero();           ///< CdA in air [m^2], each >= 0.
  std::optional<Hull> hull;
};

/// Every bound of RigidBody that `body` violates, one sentence each, beginning with `prefix`.
std::vector<std::string> validate(const RigidBody& body, const std::string& prefix = "vehicle.");

/// How the attachment of a body moves, world frame; its attitude is a AttitudeState.
struct AttachmentMotion
{
  Vector3 position, velocity, acceleration;
};

/// Motion of the end node that a body is fixed to.
inline AttachmentMotion attachmentMotion(const CableState& state, std::size_t node)
{
  return {state.q[node].head<3>(), state.v[node].head<3>(), state.a[node].head<3>()};
}

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
 * @param t       [s], for the waves.
 */
RigidBodyResidual rigidBodyResidual(const RigidBody& body, const EnvironmentModel& sea, double t,
                                    const AttachmentMotion& node, const AttitudeState& rotation,
                                    const Wrench& thrust, const TangentWeights& weights);

/// Force of weight, buoyancy, drag and the constant force on a body that moves steadily with its axes those of the
/// world [N]. @param attachment  position of the tether's end [m]; waves must be calmed.
Vector3 steadyForce(const RigidBody& body, const EnvironmentModel& sea, const Vector3& attachment,
                    const Vector3& velocity);

/// Drag of the water on a body in motion [N], world axes.
Vector3 bodyDrag(const RigidBody& body, const EnvironmentModel& sea, double t, const AttachmentMotion& node,
                 const AttitudeState& rotation);

/// Centre of mass of a body [m] whose attachment is at `attachment`.
Vector3 centreOfMass(const RigidBody& body, const Vector3& attachment, const AttitudeState& rotation);

/// The matrix of the cross product: cross(a) b = a x b.
Matrix3 skew(const Vector3& a);

}  // namespace tether_monitor::core
