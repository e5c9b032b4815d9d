#include "tether_monitor/monitor/estimator/tension_band.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double PERIOD = 1.0;         // [s]
constexpr double FASTEST_RATE = 20.0;  // [1/s]

core::Vector3 directionAt(const core::NodeCoords& node)
{
  return node.tail<3>().normalized();
}
}  // namespace

void TensionBand::begin(const core::CableModel& model)
{
  if (model.nodes() != nodes_)
    *this = TensionBand(model);
  updated_at_ = -std::numeric_limits<double>::infinity();
  vessel_ = vehicle_ = NONE;
}

void TensionBand::update(CableSimulation& simulation, const Scatter& scatter)
{
  const core::CableState& state = simulation.state;
  if (state.time < updated_at_ + PERIOD && state.time >= updated_at_)
    return;
  updated_at_ = state.time;
  vessel_ = vehicle_ = NONE;
  const double rate = std::min(1.0 / scatter.interval, FASTEST_RATE);
  if (simulation.model.nodes() != nodes_ || !solver_.solve(simulation.updatedCable(), state, rate, stiffness_))
    return;
  const core::Vector3 a = directionAt(state.q.front()), b = directionAt(state.q.back());
  vessel_ = std::hypot((a.transpose() * stiffness_.vessel).norm() * scatter.vessel,
                       (a.transpose() * stiffness_.transfer).norm() * scatter.vehicle);
  vehicle_ = std::hypot((b.transpose() * stiffness_.transfer.transpose()).norm() * scatter.vessel,
                        (b.transpose() * stiffness_.tether).norm() * scatter.vehicle);
}

}  // namespace tether_monitor::monitor
