#pragma once

#include "tether_monitor/core/solve_report.h"
#include "tether_monitor/monitor/config.h"
#include "tether_monitor/monitor/tether_estimate.h"

namespace tether_monitor::replay
{
/// A steady state as an estimate at time zero, INVALID with reason NOT_CONVERGED if there is none.
struct SteadyState
{
  monitor::TetherEstimate estimate;
  core::SolveReport report;
};

/**
 * The steady state of a configuration with both bodies level, moving together ("solution setting" of the paper).
 *
 * @param config    mode tracked: the vehicle is held at `vehicle`; mode free: it hangs from the tether.
 * @param vessel    position of the vessel's reference point [m].
 * @param vehicle   position of the vehicle's reference point [m]; not used in mode free.
 * @param velocity  of both [m/s].
 * @throws std::invalid_argument listing every problem of `config`.
 */
SteadyState findSteadyState(const monitor::Config& config, const core::Vector3& vessel,
                            const core::Vector3& vehicle, const core::Vector3& velocity);

}  // namespace tether_monitor::replay
