#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"

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

/// Every bound of WaveProperties that `waves` violates, one sentence each.
std::vector<std::string> validate(const WaveProperties& waves);

/// Surface, velocity and acceleration of the water in a wave.
struct WaveMotion
{
  double elevation = 0.0;                  ///< of the surface above still water [m].
  Vector3 velocity = Vector3::Zero();      ///< [m/s]
  Vector3 acceleration = Vector3::Zero();  ///< local, d u/dt at the point [m/s^2].
};

/**
 * Linear (Airy) wave in water of finite depth, stretched to the instantaneous surface (Wheeler).
 *
 * Model: (M21) of doc/model.md: eta = a cos(k.x - w t + phase), w^2 = g k tanh(k h).
 */
class AiryWave
{
 public:
  static constexpr double DEEP = std::numeric_limits<double>::infinity();

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
  bool isCalm() const { return amplitude_ == 0.0; }
  double frequency() const { return frequency_; }   ///< w [rad/s], in a fixed frame.
  const Vector3& wavenumber() const { return k_; }  ///< k [rad/m], horizontal.
  /// Frequency at which a body that moves with velocity V [m/s] meets the waves [rad/s], >= 0.
  double encounterFrequency(const Vector3& V) const;

  /// Height of the surface [m] over the point (x, y) at time t [s].
  double elevation(double x, double y, double t) const;
  /// Motion of the water at a point of the world [m] and time t [s]; above the surface that at the surface.
  WaveMotion at(const Vector3& point, double t) const;

 private:
  double amplitude_ = 0.0, frequency_ = 0.0, wavenumber_ = 0.0, phase_ = 0.0, depth_ = DEEP;
  Vector3 k_ = Vector3::Zero();
  Vector3 direction_ = Vector3::UnitX();
};

}  // namespace tether_monitor::core
