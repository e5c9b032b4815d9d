#include "tether_monitor/monitor/estimator/free_vehicle_end.h"

#include <algorithm>

#include "tether_monitor/core/solve/dynamic_relaxation.h"
#include "tether_monitor/monitor/estimate/estimate_summary.h"

namespace tether_monitor::monitor
{
void FreeVehicleEnd::setThrust(double t, const core::Wrench& thrust)
{
  thrust_.add(t, thrust);
}

void FreeVehicleEnd::clear()
{
  body_.clear();
  thrust_.clear();
}

double FreeVehicleEnd::age(double t, bool /*running*/) const
{
  return thrust_.age(t).value_or(0.0);
}

core::SolveReport FreeVehicleEnd::findStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                            const EndTargets& /*targets*/, VehicleInitialization& start) const
{
  return core::findSteadyState(simulation.steady_solver, modelAtRest(simulation.model, start), ends, start.shape);
}

// Level, its bow along x: the thrust's axes are the world's.
core::CableModel FreeVehicleEnd::modelAtRest(const core::CableModel& model,
                                             const VehicleInitialization& /*start*/) const
{
  core::EndBodies bodies = model.bodies();
  bodies.vehicle->force += thrust_.latest().force;
  return model.withBodies(bodies);
}

core::SolveReport FreeVehicleEnd::advance(core::BoundaryConditions& paths, const EndTargets& /*targets*/, double t,
                                          CableSimulation& simulation)
{
  paths.vehicle_thrust = thrust_.at(t);
  return simulation.stepper.advance(simulation.model, paths, t, simulation.state);
}

void FreeVehicleEnd::prepareForecast(ForecastStart& start) const
{
  start.thrust = thrust_.at(start.t);
}

void FreeVehicleEnd::describe(CableSimulation& simulation, TetherEstimate& estimate) const
{
  describeVehicle(simulation.updatedCable(), simulation.state, estimate);
}

}  // namespace tether_monitor::monitor
