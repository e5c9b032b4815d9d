#include "tether_monitor/core/environment/airy_wave.h"

#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
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

AiryWave::AiryWave(const WaveProperties& waves, double gravity, double depth) : depth_(depth)
{
  std::vector<std::string> faults = validate(waves);
  BoundsCheck check;
  check.check(depth > 0.0, "depth of the sea", depth, "> 0 m");
  check.check(waves.amplitude == 0.0 || gravity > 0.0, "gravity", gravity, "> 0 m/s^2 where there are waves");
  for (const std::string& fault : check.problems())
    faults.push_back(fault);
  throwIfInvalid("waves", faults);
  const double k = 2.0 * M_PI / waves.length;
  direction_ = Vector3(std::cos(waves.direction), std::sin(waves.direction), 0.0);
  k_ = k * direction_;
  const double w = std::sqrt(gravity * k * std::tanh(k * depth));  // (M21)
  constants_ = {waves.amplitude,
                w,
                k,
                direction_.x(),
                direction_.y(),
                waves.phase,
                waves.amplitude * w / (1.0 - std::exp(-2.0 * k * depth))};
}

void AiryWave::setTimeOrigin(double epoch)
{
  const double w = constants_.frequency;
  if (w > 0.0)
    constants_.phase -= std::fmod(epoch, 2.0 * M_PI / w) * w;
}

double AiryWave::encounterFrequency(const Vector3& V) const
{
  return std::abs(constants_.frequency - k_.dot(V));
}

AiryWave::Profile AiryWave::profile(double z) const
{
  const double kz = constants_.wavenumber * z;
  if (kz < WaveConstants::NO_MOTION)
    return {0.0, 0.0};
  const double deep = std::exp(kz);
  // cosh and sinh of k (z + h) over sinh(k h), written so that deep water does not overflow.
  const double mirror = std::isfinite(depth_) ? std::exp(-kz - 2.0 * constants_.wavenumber * depth_) : 0.0;
  return {constants_.speed * (deep + mirror), constants_.speed * (deep - mirror)};
}

}  // namespace tether_monitor::core
