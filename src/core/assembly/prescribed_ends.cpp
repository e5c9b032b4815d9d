#include "tether_monitor/core/assembly/prescribed_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor::core
{
namespace
{
constexpr double QUIET_SHARE = 0.1;  // of the dry weight: a force that counts where nothing pulls

// Rounding of coordinates [m] makes strains, and so forces, uncertain by this much [N].
double roundOff(const DeployedCable& cable, const NodeField& q)
{
  double extent = 0.0;
  for (const NodeCoords& node : q)
    extent = std::max(extent, node.head<3>().lpNorm<Eigen::Infinity>());
  return 4.0 * std::numeric_limits<double>::epsilon() * cable.largestStiffness() *
         (cable.length() / cable.elements() + extent);
}
}  // namespace

PrescribedEnds prescribedEnds(const EndBodies& bodies)
{
  return {!bodies.vessel, !bodies.vehicle};
}

void placePrescribedEnds(const EndBodies& bodies, const BoundaryConditions& ends, CableState& trial)
{
  const auto place = [&](const EndTrajectory& trajectory, std::size_t node)
  {
    trial.q[node].head<3>() = trajectory.position(trial.time);
    trial.v[node].head<3>() = trajectory.velocity(trial.time);
    trial.a[node].head<3>() = trajectory.acceleration(trial.time);
    trial.algorithmic_acceleration[node].head<3>() = trial.a[node].head<3>();
  };
  const PrescribedEnds held = prescribedEnds(bodies);
  trial.clamps = ends.clamps;
  if (held.vessel)
    place(ends.vessel, 0);
  if (held.vehicle)
    place(ends.vehicle, trial.q.size() - 1);
}

ResidualSize imposePrescribedEnds(const DeployedCable& cable, const NodeField& q, const NewtonOptions& options,
                                  const PrescribedEnds& held, NodeField& residual, double reaction)
{
  const auto hold = [&](NodeCoords& row)
  {
    reaction = std::max(reaction, row.head<3>().norm());
    row.head<3>().setZero();
  };
  if (held.vessel)
    hold(residual.front());
  if (held.vehicle)
    hold(residual.back());
  ResidualSize size{
      0.0, options.relative_tolerance * (QUIET_SHARE * cable.forceScale() + reaction) + roundOff(cable, q)};
  double sum = reaction;
  for (int i = 0; i < cable.nodes(); ++i)
  {
    const double l = cable.element(std::min(i, cable.elements() - 1)).length;
    size.largest = std::max({size.largest, residual[i].head<3>().lpNorm<Eigen::Infinity>(),
                             residual[i].tail<3>().lpNorm<Eigen::Infinity>() / l});
    sum += residual[i].sum();
  }
  if (!std::isfinite(sum))
    size.largest = std::numeric_limits<double>::quiet_NaN();
  return size;
}

void imposePrescribedEnds(const PrescribedEnds& held, BlockTridiagonal& tangent)
{
  for (int row = 0; row < 3; ++row)
  {
    if (held.vessel)
      tangent.imposeRow(0, row);
    if (held.vehicle)
      tangent.imposeRow(tangent.nodes() - 1, row);
  }
}

}  // namespace tether_monitor::core
