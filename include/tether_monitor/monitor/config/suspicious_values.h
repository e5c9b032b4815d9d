#pragma once

#include <string>
#include <vector>

#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// Values of a valid configuration that hardly any tether at sea has, one sentence each: what a slip of a unit
/// leads to.
std::vector<std::string> suspiciousValues(const Config& config);

}  // namespace tether_monitor::monitor
