#include "tether_monitor/monitor/estimator/estimate_writer.h"

#include "tether_monitor/monitor/estimate/estimate_summary.h"

namespace tether_monitor::monitor
{
void writeEstimate(CableSimulation& simulation, const VehicleEnd& vehicle, TetherEstimate& estimate)
{
  const core::CableState& state = simulation.state;
  const core::DeployedCable& cable = simulation.updatedCable();
  estimate.time = state.time;
  core::computeStations(cable, state, estimate.stations);
  for (core::Vector3& position : estimate.stations.position)
    position += simulation.origin();
  estimate.has_stations = true;
  summarize(cable, estimate);
  describeContact(cable, state, estimate);
  vehicle.describe(simulation, estimate);
}

}  // namespace tether_monitor::monitor
