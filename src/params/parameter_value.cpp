#include "tether_monitor/params/parameter_value.h"

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::params
{
std::string Value::show() const
{
  if (const auto* text = get<std::string>())
    return "'" + *text + "'";
  if (const auto* number = get<double>())
    return core::formatNumber(*number);
  if (const auto* whole = get<long>())
    return std::to_string(*whole);
  if (const auto* flag = get<bool>())
    return *flag ? "true" : "false";
  if (const auto* list = get<List>())
    return "a list of " + std::to_string(list->size());
  if (get<Map>())
    return "a map";
  return "nothing";
}

}  // namespace tether_monitor::params
