#include "tether_monitor/core/assembly/end_body_condensation.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/gravity.h"

namespace tether_monitor::core
{
namespace
{
constexpr double WEIGHT_SHARE = 1e-3;  // of a body's weight: a force that counts where nothing pulls
constexpr double LEAST_ARM = 0.1;      // [m] that makes a force of a moment
}  // namespace

double CondensedBody::assemble(const EndBodyLoad& load, const EnvironmentModel& environment,
                               const CableState& state, const TangentWeights& weights, NodeCoords& node,
                               NodeBlock diagonal)
{
  residual_ = rigidBodyResidual(load.body, environment, rigidBodyMotion(state, load.node, load.attitude),
                                load.thrust, weights);
  const Eigen::PartialPivLU<Matrix3> lu(residual_.moment_r);
  moment_ = lu.solve(residual_.moment);
  coupling_ = lu.solve(residual_.moment_n);
  node.head<3>() += residual_.force;
  diagonal.topLeftCorner<3, 3>() += residual_.force_n - residual_.force_r * coupling_;
  const double arm = std::max({load.body.attachment.norm(), std::cbrt(load.body.volume), LEAST_ARM});
  return residual_.moment.norm() / arm;
}

CondensedEndBodies::Sizes CondensedEndBodies::assemble(const DeployedCable& cable, const CableState& state,
                                                       const BoundaryConditions& ends,
                                                       const TangentWeights& weights, NodeField& residual,
                                                       BlockTridiagonal& tangent)
{
  Sizes sizes;
  const auto add = [&](const EndBodyLoad& load, CondensedBody& condensed)
  {
    NodeCoords& node = residual[load.node];
    sizes.reaction =
        std::max({sizes.reaction, node.head<3>().norm(), WEIGHT_SHARE * STANDARD_GRAVITY * load.body.mass});
    const double open = condensed.assemble(load, cable.environment(), state, weights, node,
                                           tangent.diagonal(static_cast<int>(load.node)));
    sizes.unbalanced = std::max(sizes.unbalanced, open);
  };
  const EndBodies& bodies = cable.bodies();
  if (bodies.vessel)
    add({*bodies.vessel, 0, state.vessel, ends.vessel_thrust}, vessel_);
  if (bodies.vehicle)
  {
    RigidBody body = *bodies.vehicle;
    body.force += ends.vehicle_force;
    add({body, residual.size() - 1, state.vehicle, ends.vehicle_thrust}, vehicle_);
  }
  return sizes;
}

void CondensedEndBodies::condense(const EndBodies& bodies, NodeField& residual) const
{
  if (bodies.vessel)
    vessel_.condense(residual.front());
  if (bodies.vehicle)
    vehicle_.condense(residual.back());
}

}  // namespace tether_monitor::core
