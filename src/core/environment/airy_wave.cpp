#include "tether_monitor/core/environment/airy_wave.h"

#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
constexpr double NO_MOTION = -40.0;  // k z below which nothing is left, exp(-40)
}

std::vector<std::string> validate(const WaveProperties& waves, const std::string& prefix)
{
  BoundsCheck check(prefix);
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
  speed_ = amplitude_ * frequency_ / (1.0 - std::exp(-2.0 * wavenumber_ * depth));
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

AiryWave::Profile AiryWave::profile(double z) const
{
  const double kz = wavenumber_ * z;
  if (kz < NO_MOTION)
    return {0.0, 0.0};
  const double deep = std::exp(kz);
  // cosh and sinh of k (z + h) over sinh(k h), written so that deep water does not overflow.
  const double mirror = std::isfinite(depth_) ? std::exp(-kz - 2.0 * wavenumber_ * depth_) : 0.0;
  return {speed_ * (deep + mirror), speed_ * (deep - mirror)};
}

}  // namespace tether_monitor::core
