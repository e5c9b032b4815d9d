#include "tether_monitor/core/analysis/dynamic_stiffness.h"

#include <Eigen/Dense>

#include "tether_monitor/core/assembly/end_body_condensation.h"

namespace tether_monitor::core
{
EndDynamicStiffnessSolver::EndDynamicStiffnessSolver(int nodes)
  : tangent_(nodes), residual_(nodes, NodeCoords::Zero()), columns_(nodes, NodeMatrix::Zero())
{
}

bool EndDynamicStiffnessSolver::solve(const CableModel& model, const CableState& state, double sigma,
                                      EndDynamicStiffness& impedance)
{
  const int last = model.elements();
  const TangentWeights weights{sigma * sigma, sigma, 1.0};
  model.assemble(state, weights, residual_, tangent_);

  const Matrix3 without_body = tangent_.diagonal(last).topLeftCorner<3, 3>();
  CondensedBody coupling;
  coupling.assemble(*model.bodies().vehicle, model.sea(), state.time, attachmentMotion(state, last), state.vehicle,
                    Wrench(), weights, residual_.back(), tangent_.diagonal(last));
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
  impedance.vehicle = columns_.back().topRightCorner<3, 3>().inverse();
  impedance.tether = impedance.vehicle - body;
  impedance.transfer = reaction.rightCols<3>() * impedance.vehicle;
  impedance.vessel = reaction.leftCols<3>();
  return impedance.vehicle.allFinite() && impedance.vessel.allFinite() && impedance.transfer.allFinite();
}

}  // namespace tether_monitor::core
