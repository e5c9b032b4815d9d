#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/ensemble/parameter_report.h"

namespace tether_monitor::monitor
{
/// What a record says of the tether, its water and its vehicle.
struct Identification
{
  std::vector<ParameterEstimate> parameters;  ///< `configured` is what the user configured.
  int passes = 0;
  bool has_settled = false;  ///< the last pass changed nothing by more than a quarter of a standard deviation.

  /// That of a name, "tether.drag_normal"; null if there is none.
  const ParameterEstimate* find(const std::string& name) const { return findParameter(parameters, name); }
};

/// Runs an estimator of a configuration over the record; what it believes at the end, or nothing if it never began
/// or was interrupted.
using IdentificationPass = std::function<std::optional<std::vector<ParameterEstimate>>(const Config&)>;

/**
 * Finds the parameters of a tether from a whole record, (E24) of doc/theory/estimation.md.
 *
 * Every pass begins with the answer of the one before and with the uncertainty that is configured: far from what
 * is configured the ensemble is then linear about the right place. What is built does not change within a record,
 * nor does fouling.
 *
 * @param config       mode observed.
 * @param most_passes  >= 1.
 * @return             without parameters if a pass gave none.
 */
Identification identify(const Config& config, const IdentificationPass& pass, int most_passes);

}  // namespace tether_monitor::monitor
