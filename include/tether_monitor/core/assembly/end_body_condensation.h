#pragma once

#include <Eigen/LU>

#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/core/cable/boundary_conditions.h"

namespace tether_monitor::core
{
/// A simulated body fixed to an end node, and what acts on it besides the tether and the sea.
struct EndBodyLoad
{
  const RigidBody& body;
  std::size_t node;
  const AttitudeState& attitude;
  const Wrench& thrust;  ///< at the centre of mass, body axes.
};

/**
 * Ties a simulated body to an end node: its rotation is condensed out of the iteration matrix, so that the tether
 * sees three unknowns at the node as ever, (M19).
 */
class CondensedBody
{
 public:
  /**
   * Adds the body to the equations of its node.
   *
   * @param node      rows of the residual of the node; in and out.
   * @param diagonal  block of the iteration matrix of the node; in and out.
   * @return          size of what is not balanced yet in the rotation, as a force [N].
   */
  double assemble(const EndBodyLoad& load, const EnvironmentModel& environment, const CableState& state,
                  const TangentWeights& weights, NodeCoords& node, NodeBlock diagonal);
  /// Accepts what the rotation adds to the node's right-hand side off it; after the size of the residual is known.
  void condense(NodeCoords& node) const { node.head<3>() -= residual_.force_r * moment_; }
  /// Solution of the rotation when that of the node is `delta`.
  Vector3 solve(const NodeCoords& delta) const { return moment_ - coupling_ * delta.head<3>(); }

 private:
  RigidBodyResidual residual_;
  Vector3 moment_ = Vector3::Zero();    // inverse of moment_r times the moment
  Matrix3 coupling_ = Matrix3::Zero();  // inverse of moment_r times moment_n
};

/// The bodies at both ends of a model, as far as there are any.
class CondensedEndBodies
{
 public:
  /// What the bodies tell about the size of a residual [N].
  struct Sizes
  {
    double reaction = 0.0;    ///< largest force between tether and body, or a thousandth of a body's weight.
    double unbalanced = 0.0;  ///< largest of CondensedBody::assemble().
  };

  /// Adds the bodies to residual and tangent of `state`.
  Sizes assemble(const DeployedCable& cable, const CableState& state, const BoundaryConditions& ends,
                 const TangentWeights& weights, NodeField& residual, BlockTridiagonal& tangent);
  void condense(const EndBodies& bodies, NodeField& residual) const;
  /// Solutions of the rotations when those of the nodes are in `delta`.
  Vector3 solveVessel(const NodeField& delta) const { return vessel_.solve(delta.front()); }
  Vector3 solveVehicle(const NodeField& delta) const { return vehicle_.solve(delta.back()); }

 private:
  CondensedBody vessel_, vehicle_;
};

}  // namespace tether_monitor::core
