#include "tether_monitor/simulation/heave_sensor.h"

#include <algorithm>

namespace tether_monitor::simulation
{
HeaveSensor::HeaveSensor(const HeavePlan& plan, unsigned seed) : plan_(plan), generator_(seed)
{
}

std::optional<double> HeaveSensor::sample(double t, const monitor::BodyState& truth)
{
  if (!(plan_.rate > 0.0) || t < next_ - 1e-9)
    return std::nullopt;
  next_ = std::max(next_ + 1.0 / plan_.rate, t);
  std::normal_distribution<double> noise;
  return truth.position.z() + plan_.stddev * noise(generator_);
}

}  // namespace tether_monitor::simulation
