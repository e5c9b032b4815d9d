#pragma once

#include "tether_monitor/core/environment/environment.h"
#include "tether_monitor/core/environment/wave_field.h"

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
 * Immutable: a changed environment is another one, made by the with...() functions. They allocate: not for the
 * stepping path. Points are given in the coordinates of the model; heights are those of the world.
 */
class EnvironmentModel
{
 public:
  static constexpr double AIR_DENSITY = 1.225;  ///< [kg/m^3]

  /// @throws std::invalid_argument listing violated bounds.
  explicit EnvironmentModel(const Environment& environment);

  /// The same with the model's origin elsewhere in the world [m]; z = 0. Default: the world's origin.
  EnvironmentModel withOrigin(const Vector3& origin) const;
  /// The same with times that count from `epoch` [s] of the clock in which the waves are given. Default 0.
  EnvironmentModel withTimeOrigin(double epoch) const;
  /// The same without waves, for steady states.
  EnvironmentModel withoutWaves() const;
  EnvironmentModel withCurrent(const CurrentProfile& current) const;
  /// @param obstacles  each without violated bounds, places in the world.
  EnvironmentModel withObstacles(std::vector<Obstacle> obstacles) const;
  /// The same over a level floor. @param depth  [m], > 0, deep enough for the waves; there must be a seabed.
  EnvironmentModel withDepth(double depth) const;
  /// The same in another wind [m/s]; it must be finite.
  EnvironmentModel withWind(const Vector3& wind) const;

  double density() const { return environment_.water_density; }
  double gravity() const { return environment_.gravity; }
  const Vector3& wind() const { return environment_.wind; }
  bool hasWind() const { return has_wind_; }
  const WaveField& waves() const { return waves_; }
  const CurrentProfile& current() const { return environment_.current; }
  const std::vector<Obstacle>& obstacles() const { return environment_.obstacles; }
  const std::optional<Seabed>& seabed() const { return environment_.seabed; }
  /// As a user describes it, with what was changed since.
  const Environment& description() const { return environment_; }
  const Vector3& origin() const { return origin_; }
  double timeOrigin() const { return time_origin_; }

  /// True if the water moves everywhere alike, and without waves.
  bool isUniform() const { return waves_.isCalm() && environment_.current.samples().size() <= 1; }
  /// Motion of the water at a point [m] and time t [s].
  WaterKinematics waterKinematics(const Vector3& point, double t) const
  {
    WaterKinematics water{environment_.current.at(point.z())};
    if (!waves_.isCalm())
      addWave(point, t, water);
    return water;
  }

  bool hasSeabed() const { return environment_.seabed.has_value(); }
  /// True if there is anything that a tether could touch.
  bool hasContact() const { return hasSeabed() || !environment_.obstacles.empty(); }
  /// The sea floor under (x, y) of the model; hasSeabed() must hold.
  Seabed::Place floorAt(const Vector3& point) const
  {
    return environment_.seabed->at(point.x() + origin_.x(), point.y() + origin_.y());
  }

 private:
  void addWave(const Vector3& point, double t, WaterKinematics& water) const;

  Environment environment_;
  WaveField waves_;
  Vector3 origin_ = Vector3::Zero();
  double time_origin_ = 0.0;
  bool has_wind_;
};

}  // namespace tether_monitor::core
