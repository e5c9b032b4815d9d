#pragma once

#include <vector>

#include "tether_monitor/core/analysis/vortex_shedding.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// A steady state to begin with, found.
struct SteadyStart
{
  CableSimulation simulation;
  VehicleInitialization vehicle;
  core::VortexShedding vortex_shedding;
  bool is_found = false;  ///< simulation.last_solve tells whether it is at rest.
};

/**
 * Finds the steady state between given ends, its mesh included where an accuracy is wanted.
 *
 * @param simulation  what there was before: environment, mesh and obstacles are taken over; unchanged.
 * @param obstacles   at time t.
 * @return            of no use unless is_found.
 */
SteadyStart findSteadyStart(const Config& config, const CableSimulation& simulation,
                            const std::vector<core::Obstacle>& obstacles, const VehicleEnd& vehicle, double t,
                            const EndTargets& targets);

}  // namespace tether_monitor::monitor
