#include "tether_monitor/core/environment/environment_model.h"

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

AiryWave waveOf(const Environment& environment)
{
  if (environment.waves.amplitude == 0.0)
    return AiryWave();
  return AiryWave(environment.waves, environment.gravity,
                  environment.seabed ? environment.seabed->meanDepth() : AiryWave::DEEP);
}
}  // namespace

EnvironmentModel::EnvironmentModel(const Environment& environment)
  : environment_(checked(environment)), wave_(waveOf(environment)), has_wind_(environment.wind.norm() > 0.0)
{
}

void EnvironmentModel::setDepth(double depth)
{
  environment_.seabed->depth = depth;
  environment_.seabed->grid.reset();
  environment_.seabed->slope.setZero();
  if (!wave_.isCalm())
    setEpoch(epoch_);
}

void EnvironmentModel::setEpoch(double epoch)
{
  epoch_ = epoch;
  wave_ = waveOf(environment_);
  wave_.setTimeOrigin(epoch);
}

void EnvironmentModel::addWave(const Vector3& point, double t, WaterKinematics& water) const
{
  const WaveMotion motion = wave_.at(point + origin_, t);
  water.velocity += motion.velocity;
  water.acceleration = motion.acceleration;
  water.surface = motion.elevation;
}

}  // namespace tether_monitor::core
