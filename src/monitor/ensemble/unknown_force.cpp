#include "tether_monitor/monitor/ensemble/unknown_force.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double FAST_SHARE = 0.4;  // of the unknown force, that is fast
}  // namespace

UnknownForce unknownForceOf(const Config& config)
{
  UnknownForce force;
  force.slow_stddev = unknownForceStddev(config);
  force.fast_stddev = FAST_SHARE * force.slow_stddev;
  return force;
}

}  // namespace tether_monitor::monitor
