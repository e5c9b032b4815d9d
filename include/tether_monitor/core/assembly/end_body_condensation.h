#pragma once

#include <Eigen/LU>

#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/core/linalg/block_tridiagonal.h"

namespace tether_monitor::core
{
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
  double assemble(const RigidBody& body, const EnvironmentModel& sea, double t, const AttachmentMotion& motion,
                  const AttitudeState& rotation, const Wrench& thrust, const TangentWeights& weights,
                  NodeCoords& node, NodeBlock diagonal);
  /// Takes what the rotation adds to the node's right-hand side off it; after the size of the residual is known.
  void condense(NodeCoords& node) const { node.head<3>() -= response_.force_r * moment_; }
  /// Solution of the rotation when that of the node is `delta`.
  Vector3 solve(const NodeCoords& delta) const { return moment_ - coupling_ * delta.head<3>(); }

 private:
  RigidBodyResidual response_;
  Vector3 moment_ = Vector3::Zero();    // inverse of moment_r times the moment
  Matrix3 coupling_ = Matrix3::Zero();  // inverse of moment_r times moment_n
};

}  // namespace tether_monitor::core
