#pragma once

#include <string>

#include "tether_monitor/params/parameter_value.h"

namespace tether_monitor::params
{
/**
 * The parameter tree in a YAML file. Scalars keep what they mean on the parameter server: "1e6" is a text there,
 * and becomes a number when a number is asked for.
 *
 * @throws std::runtime_error naming the file, and the line where the syntax is wrong.
 */
Value readYamlFile(const std::string& path);

}  // namespace tether_monitor::params
