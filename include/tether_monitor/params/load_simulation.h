#pragma once

#include <string>

#include "tether_monitor/params/parameter_value.h"
#include "tether_monitor/simulation/simulation_config.h"

namespace tether_monitor::params
{
/**
 * The key `simulation` of a parameter tree.
 *
 * @param tree   the whole tree.
 * @param where  named in errors: a file or a namespace.
 * @throws ParameterError listing every missing, misspelt, misshapen and out-of-range key.
 */
simulation::SimulationConfig loadSimulation(const Value& tree, const std::string& where);

}  // namespace tether_monitor::params
