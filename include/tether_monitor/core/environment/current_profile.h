#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// WaterKinematics velocity by depth: linear between the given depths, constant beyond the first and the last.
class CurrentProfile
{
 public:
  static constexpr std::size_t MOST_SAMPLES = 1000;

  /// Velocity of the water, world frame [m/s], at a depth below the still water surface [m], positive down.
  struct Sample
  {
    double depth;
    Vector3 velocity;

    template <class Archive>
    void serialize(Archive& a)
    {
      a(depth, velocity);
    }
  };

  /// Still water.
  CurrentProfile() = default;
  /// The same velocity [m/s] everywhere.
  explicit CurrentProfile(const Vector3& velocity);
  /// @param samples  in order of strictly increasing depth, finite, at most MOST_SAMPLES; empty means still
  /// water.
  /// @throws std::invalid_argument naming each sample that is out of order or not finite.
  explicit CurrentProfile(std::vector<Sample> samples);

  /// Velocity [m/s] at height z [m] (depth = -z; above the surface as at the first sample).
  Vector3 at(double z) const;

  const std::vector<Sample>& samples() const { return samples_; }

 private:
  std::vector<Sample> samples_;
};

/// What makes `samples` no profile, one sentence each.
std::vector<std::string> validate(const std::vector<CurrentProfile::Sample>& samples);

}  // namespace tether_monitor::core
