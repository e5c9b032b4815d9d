#include "tether_monitor/core/environment/airy_wave.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
std::vector<std::string> validate(const WaveProperties& waves)
{
  BoundsCheck check("environment.waves.");
  check.notNegative("amplitude", waves.amplitude, "m");
  check.positive("length", waves.length, "m");
  check.check(!(2.0 * waves.amplitude > waves.length / 7.0), "amplitude", waves.amplitude,
              "at most a fourteenth of the length: steeper waves break");
  check.finite("direction", waves.direction, "rad");
  check.finite("phase", waves.phase, "rad");
  return check.problems();
}

AiryWave::AiryWave(const WaveProperties& waves, double gravity, double depth)
  : amplitude_(waves.amplitude), phase_(waves.phase), depth_(depth)
{
  std::vector<std::string> faults = validate(waves);
  BoundsCheck check;
  check.check(depth > 0.0, "depth of the sea", depth, "> 0 m");
  check.check(waves.amplitude == 0.0 || gravity > 0.0, "gravity", gravity, "> 0 m/s^2 where there are waves");
  for (const std::string& fault : check.problems())
    faults.push_back(fault);
  throwIfInvalid("waves", faults);
  wavenumber_ = 2.0 * M_PI / waves.length;
  direction_ = Vector3(std::cos(waves.direction), std::sin(waves.direction), 0.0);
  k_ = wavenumber_ * direction_;
  frequency_ = std::sqrt(gravity * wavenumber_ * std::tanh(wavenumber_ * depth));  // (M21)
}

void AiryWave::setTimeOrigin(double epoch)
{
  if (frequency_ > 0.0)
    phase_ -= std::fmod(epoch, 2.0 * M_PI / frequency_) * frequency_;
}

double AiryWave::encounterFrequency(const Vector3& V) const
{
  return std::abs(frequency_ - k_.dot(V));
}

double AiryWave::elevation(double x, double y, double t) const
{
  return amplitude_ * std::cos(k_.x() * x + k_.y() * y - frequency_ * t + phase_);
}

WaveMotion AiryWave::at(const Vector3& point, double t) const
{
  const double angle = k_.x() * point.x() + k_.y() * point.y() - frequency_ * t + phase_;
  const double cosine = std::cos(angle), sine = std::sin(angle);
  WaveMotion motion;
  motion.elevation = amplitude_ * cosine;
  double z = std::min(point.z(), motion.elevation) - motion.elevation;
  double mirror = 0.0, floor = 0.0;
  if (std::isfinite(depth_))
  {
    z = std::max(z / (1.0 + motion.elevation / depth_), -depth_);
    mirror = std::exp(-wavenumber_ * (z + 2.0 * depth_));
    floor = std::exp(-2.0 * wavenumber_ * depth_);
  }
  const double deep = std::exp(wavenumber_ * z);
  const double along = amplitude_ * frequency_ * (deep + mirror) / (1.0 - floor);
  const double up = amplitude_ * frequency_ * (deep - mirror) / (1.0 - floor);
  motion.velocity = along * cosine * direction_ + up * sine * Vector3::UnitZ();
  motion.acceleration = frequency_ * (along * sine * direction_ - up * cosine * Vector3::UnitZ());
  return motion;
}

}  // namespace tether_monitor::core
