#include "tether_monitor/monitor/estimator/tracked_vehicle_end.h"

#include "tether_monitor/core/solve/dynamic_relaxation.h"

namespace tether_monitor::monitor
{
void TrackedVehicleEnd::aim(double t, EndTargets& targets)
{
  targets.vehicle = body_.attachmentMotion(t);
  targets.clamps.vehicle = -body_.clampDirection(t);  // it leaves the vehicle against s
  targets.vehicle_age = track().age(t);
}

core::SolveReport TrackedVehicleEnd::findStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                               const EndTargets& /*targets*/, VehicleInitialization& start) const
{
  return core::findSteadyState(simulation.steady_solver, simulation.model, ends, start.shape);
}

core::SolveReport TrackedVehicleEnd::advance(core::BoundaryConditions& paths, const EndTargets& targets, double t,
                                             CableSimulation& simulation)
{
  const core::CableState& state = simulation.state;
  paths.vehicle =
      core::EndTrajectory::between(state.time, {state.q.back().head<3>(), state.v.back().head<3>()}, t,
                                   {targets.vehicle.position - simulation.origin(), targets.vehicle.velocity});
  return simulation.stepper.advance(simulation.model, paths, t, simulation.state);
}

}  // namespace tether_monitor::monitor
