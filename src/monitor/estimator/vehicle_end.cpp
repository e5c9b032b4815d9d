#include "tether_monitor/monitor/estimator/vehicle_end.h"

#include "tether_monitor/monitor/estimator/free_vehicle_end.h"
#include "tether_monitor/monitor/estimator/observed_vehicle_end.h"
#include "tether_monitor/monitor/estimator/tracked_vehicle_end.h"

namespace tether_monitor::monitor
{
core::SolveReport VehicleEnd::refineStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                          const EndTargets& /*targets*/, VehicleInitialization& start) const
{
  return simulation.steady_solver.solveFrom(simulation.model, ends, start.shape);
}

std::unique_ptr<VehicleEnd> makeVehicleEnd(const Config& config)
{
  switch (config.vehicle_mode)
  {
    case VehicleMode::TRACKED:
      return std::make_unique<TrackedVehicleEnd>(config);
    case VehicleMode::FREE:
      return std::make_unique<FreeVehicleEnd>(config);
    case VehicleMode::OBSERVED:
      break;
  }
  return std::make_unique<ObservedVehicleEnd>(config);
}

}  // namespace tether_monitor::monitor
