#include "tether_monitor/monitor/estimator/tracked_vehicle_end.h"

#include <algorithm>

#include "tether_monitor/core/solve/dynamic_relaxation.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double UNCERTAIN_SHARE = 0.1;  // of the tension
constexpr double QUIET_SHARE = 0.02;     // of the working load: less than this is no matter
}  // namespace

TrackedVehicleEnd::TrackedVehicleEnd(const Config& config)
  : body_(config.vehicle, config.pose_timeout),
    position_stddev_(config.vehicle.position_stddev),
    working_load_(config.tether.working_load),
    band_(makeModel(config))
{
}

void TrackedVehicleEnd::begin(const VehicleInitialization& /*start*/, const EndTargets& /*targets*/,
                              CableSimulation& simulation)
{
  band_.begin(simulation.model);
}

void TrackedVehicleEnd::describe(CableSimulation& /*simulation*/, TetherEstimate& estimate) const
{
  if (!position_stddev_)
    return;
  estimate.vessel_tension_stddev = band_.vessel();
  estimate.vehicle_tension_stddev = band_.vehicle();
  estimate.vehicle_position_stddev = *position_stddev_;
}

Reason TrackedVehicleEnd::degradedReason(const TetherEstimate& e) const
{
  const auto isUncertain = [&](double stddev, double tension)
  { return stddev > std::max(UNCERTAIN_SHARE * tension, QUIET_SHARE * working_load_); };
  return isUncertain(band_.vessel(), e.vessel_tension) || isUncertain(band_.vehicle(), e.vehicle_tension)
             ? Reason::UNCERTAIN
             : Reason::NONE;
}

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
  const core::SolveReport report = simulation.stepper.advance(simulation.model, paths, t, simulation.state);
  const double interval = track().poseInterval(t);
  if (report.converged())
    band_.update(simulation, {targets.vessel_stddev.maxCoeff(),
                              std::max(position_stddev_.value_or(0.0), body_.plausibility().measuredScatter()),
                              interval > 0.0 ? interval : 1.0});
  return report;
}

}  // namespace tether_monitor::monitor
