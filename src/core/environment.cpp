#include "tether_monitor/core/environment.h"

#include "tether_monitor/core/bounds.h"

namespace tether_monitor::core
{
std::vector<std::string> problems(const Environment& environment)
{
  BoundsCheck check("environment.");
  check.notNegative("water_density", environment.water_density, "kg/m^3");
  check.notNegative("gravity", environment.gravity, "m/s^2");
  return check.problems();
}

}  // namespace tether_monitor::core
