#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/environment/wave_constants.h"

namespace tether_monitor::core
{
/// Constants of a regular wave train, as a user gives them.
struct WaveProperties
{
  double amplitude = 0.0;  ///< a [m], >= 0; zero: no waves.
  double length = 100.0;   ///< [m], > 0.
  double direction = 0.0;  ///< towards which the crests run [rad], counted from x towards y.
  double phase = 0.0;      ///< [rad]
};

/// Every bound of WaveProperties that `waves` violates, one sentence each, beginning with `prefix`.
std::vector<std::string> validate(const WaveProperties& waves, const std::string& prefix = "environment.waves.");

/**
 * Linear (Airy) wave in water of finite depth: one component of a WaveField.
 *
 * Model: (M21) of doc/model.md: eta = a cos(theta), theta = k.x - w t + phase, w^2 = g k tanh(k h). Velocity
 * (horizontal cos(theta), up sin(theta)) and local acceleration w (horizontal sin(theta), -up cos(theta)).
 */
class AiryWave
{
 public:
  static constexpr double DEEP = std::numeric_limits<double>::infinity();

  /// Sizes of the velocity at one height [m/s].
  struct Profile
  {
    double horizontal, up;
  };

  /// Still water.
  AiryWave() = default;
  /**
   * @param waves    see WaveProperties.
   * @param gravity  [m/s^2], > 0 unless the amplitude is zero.
   * @param depth    h [m], > 0; DEEP: infinite.
   * @throws std::invalid_argument listing violated bounds.
   */
  AiryWave(const WaveProperties& waves, double gravity, double depth = DEEP);

  /// Counts times from `epoch` [s] on.
  void setTimeOrigin(double epoch);
  bool isCalm() const { return constants_.amplitude == 0.0; }
  double amplitude() const { return constants_.amplitude; }  ///< a [m].
  double frequency() const { return constants_.frequency; }  ///< w [rad/s], in a fixed frame.
  const WaveConstants& constants() const { return constants_; }
  const Vector3& wavenumber() const { return k_; }         ///< k [rad/m], horizontal.
  const Vector3& direction() const { return direction_; }  ///< unit vector, horizontal.
  /// Frequency at which a body that moves with velocity V [m/s] meets the waves [rad/s], >= 0.
  double encounterFrequency(const Vector3& V) const;

  /// theta [rad] over the point (x, y) at time t [s].
  double angle(double x, double y, double t) const
  {
    return k_.x() * x + k_.y() * y - constants_.frequency * t + constants_.phase;
  }
  /// @param z  height [m] to which the motion dies away, stretched or not; -h <= z.
  Profile profile(double z) const;

 private:
  WaveConstants constants_;
  double depth_ = DEEP;
  Vector3 k_ = Vector3::Zero();
  Vector3 direction_ = Vector3::UnitX();
};

}  // namespace tether_monitor::core
