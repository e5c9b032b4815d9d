#pragma once

#include <vector>

#include "tether_monitor/core/analysis/natural_modes.h"
#include "tether_monitor/core/analysis/vortex_shedding.h"
#include "tether_monitor/core/base/solve_report.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor::replay
{
/// A steady state as an estimate at time zero, INVALID with reason NOT_CONVERGED if there is none.
struct SteadyState
{
  monitor::TetherEstimate estimate;
  core::SolveReport report;
  std::vector<core::Mode> modes;  ///< as many as wanted, if there are so many.
  core::VortexShedding vortex_shedding;
  /// Unstretched arc lengths of the nodes [m].
  std::vector<double> node_s;
};

/**
 * The steady state of a configuration with both bodies level, moving together ("solution setting" of the paper),
 * waves taken away.
 *
 * @param config    modes tracked and observed: the vehicle is held at `vehicle`; mode free: it hangs from
 *                  the tether.
 * @param vessel    position of the vessel's reference point [m].
 * @param vehicle   position of the vehicle's reference point [m]; not used in mode free.
 * @param velocity  of both [m/s].
 * @param modes     number of natural modes wanted, >= 0.
 * @throws std::invalid_argument listing every problem of `config`.
 */
SteadyState findSteadyState(const monitor::Config& config, const core::Vector3& vessel,
                            const core::Vector3& vehicle, const core::Vector3& velocity, int modes = 0);

}  // namespace tether_monitor::replay
