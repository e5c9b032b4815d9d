#pragma once

#include <vector>

#include "tether_monitor/core/environment/sea_state.h"

namespace tether_monitor::core
{
/// Surface, velocity and acceleration of the water in waves.
struct WaveMotion
{
  double elevation = 0.0;                  ///< of the surface above still water [m].
  Vector3 velocity = Vector3::Zero();      ///< [m/s]
  Vector3 acceleration = Vector3::Zero();  ///< local, d u/dt at the point [m/s^2].
};

/**
 * The motion of the water in a sea state: the sum of its Airy waves, (M21) of doc/model.md.
 *
 * Its functions allocate nothing; at() costs in proportion to the number of components.
 */
class WaveField
{
 public:
  /// Still water.
  WaveField() = default;
  /**
   * @param waves    without violated bounds.
   * @param gravity  [m/s^2], > 0 unless calm.
   * @param depth    of the sea [m], > 0; AiryWave::DEEP: infinite.
   * @param epoch    times count from here on [s].
   */
  WaveField(const SeaState& waves, double gravity, double depth = AiryWave::DEEP, double epoch = 0.0);

  bool isCalm() const { return components_.empty(); }
  const std::vector<AiryWave>& components() const { return components_; }
  /// Those of components().
  const std::vector<WaveConstants>& constants() const { return constants_; }
  double depth() const { return depth_; }  ///< h [m]
  bool isStretched() const { return stretching_ == WaveStretching::WHEELER; }
  /// The wave of a spectrum's peak, or the highest component; calm where there is none.
  const AiryWave& dominant() const { return dominant_; }

  /// Height of the surface [m] over the point (x, y) at time t [s].
  double elevation(double x, double y, double t) const;
  /// Motion of the water at a point of the world [m] and time t [s]; above the surface that at the surface.
  WaveMotion at(const Vector3& point, double t) const;

 private:
  double profileHeight(double z, double elevation) const;

  std::vector<AiryWave> components_;
  std::vector<WaveConstants> constants_;
  AiryWave dominant_;
  double depth_ = AiryWave::DEEP;
  WaveStretching stretching_ = WaveStretching::WHEELER;
};

}  // namespace tether_monitor::core
