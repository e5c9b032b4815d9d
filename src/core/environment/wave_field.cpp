#include "tether_monitor/core/environment/wave_field.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
WaveField::WaveField(const SeaState& waves, double gravity, double depth, double epoch)
  : depth_(depth), stretching_(waves.stretching)
{
  std::vector<WaveProperties> given = waves.components;
  if (waves.spectrum)
    given = waveComponents(*waves.spectrum, gravity, depth);
  for (const WaveProperties& wave : given)
  {
    if (wave.amplitude == 0.0)
      continue;
    components_.emplace_back(wave, gravity, depth);
    components_.back().setTimeOrigin(epoch);
    constants_.push_back(components_.back().constants());
  }
  if (waves.spectrum)
    dominant_ = AiryWave(peakWave(*waves.spectrum, gravity, depth), gravity, depth);
  else if (!components_.empty())
    dominant_ =
        *std::max_element(components_.begin(), components_.end(),
                          [](const AiryWave& a, const AiryWave& b) { return a.amplitude() < b.amplitude(); });
}

double WaveField::elevation(double x, double y, double t) const
{
  double sum = 0.0;
  for (const AiryWave& wave : components_)
    sum += wave.amplitude() * std::cos(wave.angle(x, y, t));
  return sum;
}

double WaveField::profileHeight(double z, double elevation) const
{
  if (stretching_ == WaveStretching::NONE)
    return std::clamp(z, -depth_, 0.0);
  const double below = std::min(z - elevation, 0.0);
  return std::isfinite(depth_) ? std::max(below / (1.0 + elevation / depth_), -depth_) : below;
}

WaveMotion WaveField::at(const Vector3& point, double t) const
{
  double cosine[MOST_WAVES], sine[MOST_WAVES];
  const int n = static_cast<int>(components_.size());
  WaveMotion motion;
  for (int i = 0; i < n; ++i)
  {
    const double angle = components_[i].angle(point.x(), point.y(), t);
    cosine[i] = std::cos(angle);
    sine[i] = std::sin(angle);
    motion.elevation += components_[i].amplitude() * cosine[i];
  }
  const double z = profileHeight(point.z(), motion.elevation);
  for (int i = 0; i < n; ++i)
  {
    const AiryWave& wave = components_[i];
    const AiryWave::Profile profile = wave.profile(z);
    const double w = wave.frequency();
    motion.velocity += profile.horizontal * cosine[i] * wave.direction();
    motion.velocity.z() += profile.up * sine[i];
    motion.acceleration += w * profile.horizontal * sine[i] * wave.direction();
    motion.acceleration.z() -= w * profile.up * cosine[i];
  }
  return motion;
}

}  // namespace tether_monitor::core
