#pragma once

#include <string>
#include <vector>

#include "tether_monitor/params/load_config.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// The keys that a tether must have, those of the tow cable.
inline Value::Map tetherKeys()
{
  return {{"length", 400.0},         {"elements", 50.0},          {"diameter", 0.03},
          {"mass_per_length", 1.43}, {"axial_stiffness", 6.75e7}, {"drag_normal", 1.35},
          {"drag_tangential", 0.04}, {"working_load", 2.0e4},     {"breaking_load", 6.0e4}};
}
inline Value tree(const Value::Map& tether, Value::Map more = {})
{
  more["tether"] = Value(tether);
  return Value(more);
}
inline std::vector<std::string> faultsOf(const Value& value)
{
  try
  {
    loadConfig(value, "/test");
    return {};
  }
  catch (const ParameterError& error)
  {
    return error.errors();
  }
}
}  // namespace tether_monitor::params
