#include "tether_monitor/core/environment/sea_state.h"

#include <algorithm>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
bool SeaState::isCalm() const
{
  return !spectrum && std::all_of(components.begin(), components.end(),
                                  [](const WaveProperties& wave) { return wave.amplitude == 0.0; });
}

double SeaState::largestElevation() const
{
  double sum = spectrum ? spectrum->significant_height : 0.0;
  for (const WaveProperties& wave : components)
    sum += wave.amplitude;
  return sum;
}

std::vector<std::string> validate(const SeaState& waves, double gravity)
{
  BoundsCheck check("environment.");
  check.check(waves.isCalm() || gravity > 0.0, "gravity", gravity, "> 0 m/s^2 where there are waves");
  check.within("waves (number of components)", static_cast<double>(waves.components.size()), 0, MOST_WAVES, "[-]");
  check.check(!waves.spectrum || waves.components.empty(), "waves (number of components)",
              static_cast<double>(waves.components.size()), "0 beside a spectrum");
  std::vector<std::string> found = check.problems();
  const auto add = [&](const std::vector<std::string>& more)
  { found.insert(found.end(), more.begin(), more.end()); };
  if (waves.spectrum)
    add(validate(*waves.spectrum, gravity));
  for (std::size_t i = 0; i < waves.components.size(); ++i)
    add(validate(waves.components[i], waves.components.size() == 1
                                          ? "environment.waves."
                                          : "environment.waves[" + std::to_string(i) + "]."));
  return found;
}

}  // namespace tether_monitor::core
