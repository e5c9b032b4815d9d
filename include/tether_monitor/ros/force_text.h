#pragma once

#include <string>

namespace tether_monitor
{
/// A force for a person to read, three figures and the unit: "4.54 kN", "82 N"; "unknown" for what is no number.
std::string forceText(double newtons);
}  // namespace tether_monitor
