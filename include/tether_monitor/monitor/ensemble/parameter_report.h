#pragma once

#include <string>
#include <vector>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/ensemble/tether_ensemble.h"

namespace tether_monitor::monitor
{
/// What is believed of one parameter, beside what was configured; in the unit of its key.
struct ParameterEstimate
{
  std::string name;
  double mean = 0.0, stddev = 0.0, configured = 0.0, configured_stddev = 0.0;
};

/**
 * Everything that an ensemble believes: tether, current at the surface, vehicle, load cell. `vehicle.drag` is a
 * factor on the drag areas, `tension.bias` in N. For set-up and reports: allocates.
 *
 * @param length   deployed, as measured or configured [m].
 * @param current  that the ensemble was given [m/s], at the surface.
 */
std::vector<ParameterEstimate> parameterReport(const TetherEnsemble& ensemble, const Config& config, double length,
                                               const core::Vector3& current);

}  // namespace tether_monitor::monitor
