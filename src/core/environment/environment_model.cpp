#include "tether_monitor/core/environment/environment_model.h"

#include <utility>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
const Environment& checked(const Environment& environment)
{
  throwIfInvalid("environment", validate(environment));
  return environment;
}

WaveField wavesOf(const Environment& environment, double time_origin)
{
  if (environment.waves.isCalm())
    return WaveField();
  return WaveField(environment.waves, environment.gravity,
                   environment.seabed ? environment.seabed->meanDepth() : AiryWave::DEEP, time_origin);
}
}  // namespace

EnvironmentModel::EnvironmentModel(const Environment& environment)
  : environment_(checked(environment)), waves_(wavesOf(environment, 0.0)), has_wind_(environment.wind.norm() > 0.0)
{
}

EnvironmentModel EnvironmentModel::withOrigin(const Vector3& origin) const
{
  EnvironmentModel changed = *this;
  changed.origin_ = origin;
  return changed;
}

EnvironmentModel EnvironmentModel::withTimeOrigin(double epoch) const
{
  EnvironmentModel changed = *this;
  changed.time_origin_ = epoch;
  changed.waves_ = wavesOf(environment_, epoch);
  return changed;
}

EnvironmentModel EnvironmentModel::withoutWaves() const
{
  EnvironmentModel changed = *this;
  changed.waves_ = WaveField();
  return changed;
}

EnvironmentModel EnvironmentModel::withCurrent(const CurrentProfile& current) const
{
  EnvironmentModel changed = *this;
  changed.environment_.current = current;
  return changed;
}

EnvironmentModel EnvironmentModel::withObstacles(std::vector<Obstacle> obstacles) const
{
  EnvironmentModel changed = *this;
  changed.environment_.obstacles = std::move(obstacles);
  return changed;
}

EnvironmentModel EnvironmentModel::withWind(const Vector3& wind) const
{
  EnvironmentModel changed = *this;
  changed.environment_.wind = wind;
  changed.has_wind_ = wind.norm() > 0.0;
  return changed;
}

EnvironmentModel EnvironmentModel::withDepth(double depth) const
{
  EnvironmentModel changed = *this;
  changed.environment_.seabed->depth = depth;
  changed.environment_.seabed->grid.reset();
  changed.environment_.seabed->slope.setZero();
  if (!waves_.isCalm())
    changed.waves_ = wavesOf(changed.environment_, time_origin_);
  return changed;
}

void EnvironmentModel::addWave(const Vector3& point, double t, WaterKinematics& water) const
{
  const WaveMotion motion = waves_.at(point + origin_, t);
  water.velocity += motion.velocity;
  water.acceleration = motion.acceleration;
  water.surface = motion.elevation;
}

}  // namespace tether_monitor::core
