#include "tether_monitor/core/environment/current_profile.h"

#include <cmath>

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
  for (std::size_t i = 1; i < samples_.size(); ++i)
  {
    const Sample& lo = samples_[i - 1];
    const Sample& hi = samples_[i];
    if (depth <= hi.depth)
      return lo.velocity + (depth - lo.depth) / (hi.depth - lo.depth) * (hi.velocity - lo.velocity);
  }
  return samples_.back().velocity;
}

std::vector<std::string> validate(const std::vector<CurrentProfile::Sample>& samples)
{
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
