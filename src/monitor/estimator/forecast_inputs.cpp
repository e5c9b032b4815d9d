#include "tether_monitor/monitor/estimator/forecast_inputs.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
core::EndMotion endOf(const CableSimulation& simulation, std::size_t node)
{
  const core::CableState& state = simulation.state;
  return {state.q[node].head<3>() + simulation.origin(), state.v[node].head<3>()};
}
}  // namespace

void ForecastInputs::observe(const CableSimulation& simulation, const VehicleEnd& vehicle)
{
  vessel_.observe(simulation.state.time, endOf(simulation, 0));
  if (!vehicle.takesThrust())
    vehicle_.observe(simulation.state.time, endOf(simulation, simulation.state.q.size() - 1));
}

void ForecastInputs::clear()
{
  vessel_.clear();
  vehicle_.clear();
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
  start.vessel = vessel_;
  start.plan = plan_;
  start.payout_plan = payout_plan_;
  if (!vehicle.takesThrust())
    start.vehicle = vehicle_;
  vehicle.prepareForecast(start);
  if (start.members.empty())
    start.members.push_back({simulation.state});
  return start;
}

}  // namespace tether_monitor::monitor
