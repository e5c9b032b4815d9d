#pragma once

#include <functional>
#include <string>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/params/parameter_reader.h"
#include "tether_monitor/params/parameter_value.h"

namespace tether_monitor::params
{
/**
 * The configuration that a parameter tree holds: the same for the node and for the offline tools.
 *
 * @param tree   the whole tree.
 * @param where  named in errors: a file or a namespace.
 * @param folder  from which file names in the tree are counted; empty: the working folder.
 * @throws ParameterError listing every missing, misspelt, misshapen and out-of-range key.
 */
monitor::Config loadConfig(const Value& tree, const std::string& where, const std::string& folder = "");

/// The same from a YAML file; file names in it are counted from its folder. @throws also as readYamlFile().
/// @param prepare  what is done to the tree before it is read.
monitor::Config loadConfigFile(const std::string& path, const std::function<Value(Value)>& prepare = nullptr);

}  // namespace tether_monitor::params
