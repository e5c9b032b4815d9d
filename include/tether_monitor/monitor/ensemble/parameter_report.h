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
  /// Of the standard deviation that was configured: what is left of it where measurements say nothing.
  static constexpr double NOT_TOLD = 0.8;

  std::string name;
  double mean = 0.0, stddev = 0.0, configured = 0.0, configured_stddev = 0.0;

  /// True if measurements say more than was known before.
  bool isTold() const { return stddev < NOT_TOLD * configured_stddev; }
  /// Difference from what is configured, in standard deviations of what was known of it.
  double surprise() const { return (mean - configured) / configured_stddev; }
};

/// That of a name, "tether.drag_normal"; null if there is none.
const ParameterEstimate* findParameter(const std::vector<ParameterEstimate>& parameters, const std::string& name);

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
