#include "tether_monitor/monitor/estimator/forecast_inputs.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double USUAL_RESERVE = 2.0;  // of the largest thrust over the largest that was reported

core::EndMotion endOf(const CableSimulation& simulation, std::size_t node)
{
  const core::CableState& state = simulation.state;
  return {state.q[node].head<3>() + simulation.origin(), state.v[node].head<3>()};
}
}  // namespace

void ForecastInputs::observe(const TetherEstimate& estimate, const CableSimulation& simulation,
                             const VehicleEnd& vehicle)
{
  const core::EndMotion end = endOf(simulation, 0);
  vessel_.observe(simulation.state.time, end);
  if (std::isfinite(estimate.payout_rate))
    winch_.observe(simulation.state.time, estimate.payout_rate,
                   WinchReaction::away(simulation.state, end.velocity));
  if (!vehicle.takesThrust())
    vehicle_.observe(simulation.state.time, endOf(simulation, simulation.state.q.size() - 1));
  else if (const auto thrust = vehicle.reportedThrust(estimate.time); thrust && estimate.has_vehicle)
    reaction_.observe(estimate.time, estimate.vehicle.orientation * thrust->force, estimate.stations.ends.vehicle);
}

void ForecastInputs::clear()
{
  vessel_.clear();
  vehicle_.clear();
  reaction_.clear();
  winch_.clear();
}

void ForecastInputs::clearPlans()
{
  plan_.set({});
  payout_plan_.reset();
}

ForecastStart ForecastInputs::start(const CableSimulation& simulation, const VehicleEnd& vehicle,
                                    double payout_rate) const
{
  ForecastStart start;
  start.t = simulation.state.time;
  start.model = simulation.model;
  start.options = simulation.stepper.options();
  start.has_winch = std::isfinite(payout_rate);
  start.payout_rate = start.has_winch ? payout_rate : 0.0;
  if (start.has_winch)
    start.winch = winch_;
  start.vessel = vessel_;
  start.plan = plan_;
  start.payout_plan = payout_plan_;
  if (!vehicle.takesThrust())
    start.vehicle = vehicle_;
  if (reaction_.isReady())
  {
    start.reaction = reaction_;
    start.max_thrust = max_thrust_.value_or(USUAL_RESERVE * reaction_.largestThrust());
  }
  vehicle.prepareForecast(start);
  if (start.members.empty())
    start.members.push_back({simulation.state});
  return start;
}

}  // namespace tether_monitor::monitor
