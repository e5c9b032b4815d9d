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
  check.check(environment.waves.amplitude == 0.0 || environment.gravity > 0.0, "gravity", environment.gravity,
              "> 0 m/s^2 where there are waves");
  if (environment.seabed)
  {
    const double depth = environment.seabed->meanDepth();
    check.check(!(environment.waves.amplitude > 0.4 * depth), "waves.amplitude", environment.waves.amplitude,
                "at most 0.4 times the depth of the sea");
  }
  std::vector<std::string> found = check.problems();
  const auto add = [&](const std::vector<std::string>& more)
  { found.insert(found.end(), more.begin(), more.end()); };
  add(validate(environment.waves));
  if (environment.seabed)
    add(validate(*environment.seabed));
  for (std::size_t i = 0; i < environment.obstacles.size(); ++i)
    add(validate(environment.obstacles[i], "environment.obstacles[" + std::to_string(i) + "]."));
  return found;
}

}  // namespace tether_monitor::core
