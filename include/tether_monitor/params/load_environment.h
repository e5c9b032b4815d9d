#pragma once

#include <string>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// The keys of `environment`, errors collected in `in`. @param folder  from which file names are counted.
void loadEnvironment(ParameterReader in, const std::string& folder, monitor::Config& config);

}  // namespace tether_monitor::params
