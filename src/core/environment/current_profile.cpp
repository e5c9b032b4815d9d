#include "tether_monitor/core/environment/current_profile.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
CurrentProfile::CurrentProfile(const Vector3& velocity) : CurrentProfile(std::vector<Sample>{{0.0, velocity}})
{
}

CurrentProfile::CurrentProfile(std::vector<Sample> samples) : samples_(std::move(samples))
{
  throwIfInvalid("current profile", validate(samples_));
}

Vector3 CurrentProfile::at(double z) const
{
  if (samples_.empty())
    return Vector3::Zero();
  const double depth = -z;
  if (depth <= samples_.front().depth)
    return samples_.front().velocity;
  if (!(depth < samples_.back().depth))
    return samples_.back().velocity;
  const auto hi = std::upper_bound(samples_.begin(), samples_.end(), depth,
                                   [](double d, const Sample& sample) { return d < sample.depth; });
  const Sample& lo = *std::prev(hi);
  return lo.velocity + (depth - lo.depth) / (hi->depth - lo.depth) * (hi->velocity - lo.velocity);
}

std::vector<std::string> validate(const std::vector<CurrentProfile::Sample>& samples)
{
  if (samples.size() > CurrentProfile::MOST_SAMPLES)
    return {"current has " + std::to_string(samples.size()) + " entries (at most " +
            std::to_string(CurrentProfile::MOST_SAMPLES) + ": more would take the time of the tether's steps)"};
  std::vector<std::string> found;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const std::string name = "current[" + std::to_string(i) + "]";
    if (!std::isfinite(samples[i].depth))
      found.push_back(name + ".depth = " + formatNumber(samples[i].depth) + " (must be finite, in m)");
    else if (i > 0 && !(samples[i].depth > samples[i - 1].depth))
      found.push_back(name + ".depth = " + formatNumber(samples[i].depth) +
                      " (must be greater than the depth before it)");
    if (!samples[i].velocity.allFinite())
      found.push_back(name + ".velocity is not finite (must be finite, in m/s)");
  }
  return found;
}

}  // namespace tether_monitor::core
