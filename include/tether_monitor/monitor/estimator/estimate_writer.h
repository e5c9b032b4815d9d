#pragma once

#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// Writes time, stations, contacts, vehicle and all that follows from them into an estimate; status, reason and
/// ages are left to the caller. Allocates nothing.
void writeEstimate(CableSimulation& simulation, const VehicleEnd& vehicle, TetherEstimate& estimate);

}  // namespace tether_monitor::monitor
