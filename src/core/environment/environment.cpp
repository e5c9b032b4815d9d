#include "tether_monitor/core/environment/environment.h"

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
std::vector<std::string> validate(const Environment& environment)
{
  BoundsCheck check("environment.");
  check.notNegative("water_density", environment.water_density, "kg/m^3");
  check.notNegative("gravity", environment.gravity, "m/s^2");
  check.finite("wind (norm)", environment.wind.norm(), "m/s");
  if (environment.seabed)
  {
    const double depth = environment.seabed->meanDepth();
    check.check(!(environment.waves.largestElevation() > 0.4 * depth), "waves (largest elevation)",
                environment.waves.largestElevation(), "at most 0.4 times the depth of the sea");
  }
  std::vector<std::string> found = check.problems();
  const auto add = [&](const std::vector<std::string>& more)
  { found.insert(found.end(), more.begin(), more.end()); };
  add(validate(environment.waves, environment.gravity));
  if (environment.seabed)
    add(validate(*environment.seabed));
  for (std::size_t i = 0; i < environment.obstacles.size(); ++i)
    add(validate(environment.obstacles[i], "environment.obstacles[" + std::to_string(i) + "]."));
  return found;
}

}  // namespace tether_monitor::core
