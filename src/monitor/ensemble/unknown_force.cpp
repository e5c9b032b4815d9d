#include "tether_monitor/monitor/ensemble/unknown_force.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double DEFAULT_ACCELERATION = 0.16;  // unknown force, over the mass [m/s^2]
constexpr double FAST_SHARE = 0.4;             // of the unknown force, that is fast
}  // namespace

UnknownForce unknownForceOf(const Config& config)
{
  UnknownForce force;
  force.slow_stddev = config.navigation.force_stddev.value_or(DEFAULT_ACCELERATION * config.vehicle_body.mass);
  force.fast_stddev = FAST_SHARE * force.slow_stddev;
  return force;
}

}  // namespace tether_monitor::monitor
