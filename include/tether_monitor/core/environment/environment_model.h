#pragma once

#include "tether_monitor/core/environment/airy_wave.h"
#include "tether_monitor/core/environment/environment.h"

namespace tether_monitor::core
{
/// What the water does at one point.
struct WaterKinematics
{
  Vector3 velocity;                        ///< current and waves [m/s].
  Vector3 acceleration = Vector3::Zero();  ///< of the waves [m/s^2].
  double surface = 0.0;                    ///< height of the surface above the point's x, y [m].
};

/**
 * An Environment ready for the stepping path, seen from a model whose coordinates have their own origin.
 *
 * Points are given in the coordinates of the model; heights are those of the world.
 */
class EnvironmentModel
{
 public:
  static constexpr double AIR_DENSITY = 1.225;  ///< [kg/m^3]

  /// @throws std::invalid_argument listing violated bounds.
  EnvironmentModel(const Environment& environment);  // NOLINT: an environment is a sea at the world's origin

  double density() const { return environment_.water_density; }
  double gravity() const { return environment_.gravity; }
  const Vector3& wind() const { return environment_.wind; }
  bool hasWind() const { return has_wind_; }
  const AiryWave& wave() const { return wave_; }
  const Environment& environment() const { return environment_; }

  /// Place of the model's origin in the world [m], z = 0. Default zero.
  void setOrigin(const Vector3& origin) { origin_ = origin; }
  const Vector3& origin() const { return origin_; }
  /// Replaces parts of the environment. They allocate: not for the stepping path.
  void setCurrent(const CurrentProfile& current) { environment_.current = current; }
  void setObstacles(const std::vector<Obstacle>& obstacles) { environment_.obstacles = obstacles; }
  /// Depth of a seabed that there is already [m], > 0; a grid is dropped.
  void setDepth(double depth);
  /// Times count from `epoch` [s] of the clock that the waves are told in. Default zero.
  void setEpoch(double epoch);
  double epoch() const { return epoch_; }
  /// Takes the waves away, for steady states.
  void withoutWaves() { wave_ = AiryWave(); }

  /// True if the water moves everywhere alike, and without waves.
  bool isUniform() const { return wave_.isCalm() && environment_.current.samples().size() <= 1; }
  /// Motion of the water at a point [m] and time t [s].
  WaterKinematics waterKinematics(const Vector3& point, double t) const
  {
    WaterKinematics water{environment_.current.at(point.z())};
    if (!wave_.isCalm())
      addWave(point, t, water);
    return water;
  }

  bool hasSeabed() const { return environment_.seabed.has_value(); }
  /// The sea floor under (x, y) of the model; hasSeabed() must hold.
  Seabed::Place floorAt(const Vector3& point) const
  {
    return environment_.seabed->at(point.x() + origin_.x(), point.y() + origin_.y());
  }

 private:
  void addWave(const Vector3& point, double t, WaterKinematics& water) const;

  Environment environment_;
  AiryWave wave_;
  Vector3 origin_ = Vector3::Zero();
  double epoch_ = 0.0;
  bool has_wind_;
};

}  // namespace tether_monitor::core
