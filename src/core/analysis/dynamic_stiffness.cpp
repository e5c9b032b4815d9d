#include "tether_monitor/core/analysis/dynamic_stiffness.h"

#include <Eigen/Dense>

namespace tether_monitor::core
{
EndDynamicStiffnessSolver::EndDynamicStiffnessSolver(int nodes)
  : tangent_(nodes), residual_(nodes, NodeCoords::Zero()), columns_(nodes, NodeMatrix::Zero())
{
}

bool EndDynamicStiffnessSolver::solve(const DeployedCable& cable, const CableState& state, double sigma,
                                      EndDynamicStiffness& stiffness)
{
  const int last = cable.elements();
  const TangentWeights weights{sigma * sigma, sigma, 1.0};
  cable.assemble(state, weights, residual_, tangent_);

  const Matrix3 without_body = tangent_.diagonal(last).topLeftCorner<3, 3>();
  if (const std::optional<RigidBody>& vehicle = cable.bodies().vehicle)
  {
    CondensedBody condensed;
    const Wrench no_thrust;
    condensed.assemble({*vehicle, static_cast<std::size_t>(last), state.vehicle, no_thrust}, cable.environment(),
                       state, weights, residual_.back(), tangent_.diagonal(last));
  }
  const Matrix3 body = tangent_.diagonal(last).topLeftCorner<3, 3>() - without_body;

  const Eigen::Matrix<double, 3, 6> own = tangent_.diagonal(0).topRows<3>();
  const Eigen::Matrix<double, 3, 6> next = tangent_.upper(0).topRows<3>();
  for (int row = 0; row < 3; ++row)
    tangent_.imposeRow(0, row);

  for (NodeCoords& r : residual_)
    r.setZero();
  if (!tangent_.solvePivoted(residual_))
    return false;
  // Unit displacements of the vessel end beside unit forces on the vehicle.
  for (NodeMatrix& c : columns_)
    c.setZero();
  columns_.front().topLeftCorner<3, 3>().setIdentity();
  columns_.back().topRightCorner<3, 3>().setIdentity();
  tangent_.solveWithFactors(columns_);

  const Eigen::Matrix<double, 3, 6> reaction = own * columns_[0] + next * columns_[1];
  stiffness.vehicle = columns_.back().topRightCorner<3, 3>().inverse();
  stiffness.tether = stiffness.vehicle - body;
  stiffness.transfer = reaction.rightCols<3>() * stiffness.vehicle;
  stiffness.vessel = reaction.leftCols<3>();
  return stiffness.vehicle.allFinite() && stiffness.vessel.allFinite() && stiffness.transfer.allFinite();
}

bool EndDynamicStiffnessSolver::solve(const CableModel& model, const CableState& state, double sigma,
                                      EndDynamicStiffness& stiffness)
{
  return solve(DeployedCable(model, state.deployment), state, sigma, stiffness);
}

}  // namespace tether_monitor::core
