#include "tether_monitor/monitor/estimator/free_vehicle_end.h"

#include <algorithm>

#include "tether_monitor/core/solve/dynamic_relaxation.h"
#include "tether_monitor/monitor/estimate/estimate_summary.h"

namespace tether_monitor::monitor
{
void FreeVehicleEnd::setThrust(double t, const core::Wrench& thrust)
{
  thrust_time_ = t;
  thrust_ = thrust;
}

void FreeVehicleEnd::clear()
{
  body_.clear();
  thrust_ = core::Wrench();
  thrust_time_.reset();
}

double FreeVehicleEnd::age(double t, bool /*running*/) const
{
  return thrust_time_ ? std::max(t - *thrust_time_, 0.0) : 0.0;
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
  bodies.vehicle->force += thrust_.force;
  return model.withBodies(bodies);
}

core::SolveReport FreeVehicleEnd::advance(core::BoundaryConditions& paths, const EndTargets& /*targets*/, double t,
                                          CableSimulation& simulation)
{
  paths.vehicle_thrust = thrust_;
  return simulation.stepper.advance(simulation.model, paths, t, simulation.state);
}

void FreeVehicleEnd::describe(CableSimulation& simulation, TetherEstimate& estimate) const
{
  describeVehicle(simulation.updatedCable(), simulation.state, estimate);
}

}  // namespace tether_monitor::monitor
