#pragma once

#include <string>

#include "tether_monitor/core/environment/environment.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// The keys of `environment`, errors collected in `in`. @param folder  from which file names are counted.
/// @param current_stddev  in and out [m/s].
core::Environment loadEnvironment(ParameterReader in, const std::string& folder, double& current_stddev);

}  // namespace tether_monitor::params
