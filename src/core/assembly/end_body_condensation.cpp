#include "tether_monitor/core/assembly/end_body_condensation.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
double CondensedBody::assemble(const RigidBody& body, const EnvironmentModel& sea, double t,
                               const AttachmentMotion& motion, const AttitudeState& rotation, const Wrench& thrust,
                               const TangentWeights& weights, NodeCoords& node, NodeBlock diagonal)
{
  response_ = rigidBodyResidual(body, sea, t, motion, rotation, thrust, weights);
  const Eigen::PartialPivLU<Matrix3> lu(response_.moment_r);
  moment_ = lu.solve(response_.moment);
  coupling_ = lu.solve(response_.moment_n);
  node.head<3>() += response_.force;
  diagonal.topLeftCorner<3, 3>() += response_.force_n - response_.force_r * coupling_;
  const double arm = std::max({body.attachment.norm(), std::cbrt(body.volume), 0.1});
  return response_.moment.norm() / arm;
}

}  // namespace tether_monitor::core
