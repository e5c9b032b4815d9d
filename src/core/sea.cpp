#include "tether_monitor/core/sea.h"

#include "tether_monitor/core/bounds.h"

namespace tether_monitor::core
{
namespace
{
const Environment& checked(const Environment& environment)
{
  throwIfAny("environment", problems(environment));
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

Sea::Sea(const Environment& environment)
  : environment_(checked(environment)), wave_(waveOf(environment)), has_wind_(environment.wind.norm() > 0.0)
{
}

void Sea::setDepth(double depth)
{
  environment_.seabed->depth = depth;
  environment_.seabed->grid.reset();
  environment_.seabed->slope.setZero();
  if (!wave_.isCalm())
    setEpoch(epoch_);
}

void Sea::setEpoch(double epoch)
{
  epoch_ = epoch;
  wave_ = waveOf(environment_);
  wave_.delay(epoch);
}

void Sea::addWave(const Vector3& point, double t, Water& water) const
{
  const WaveMotion motion = wave_.at(point + origin_, t);
  water.velocity += motion.velocity;
  water.acceleration = motion.acceleration;
  water.surface = motion.elevation;
}

}  // namespace tether_monitor::core
