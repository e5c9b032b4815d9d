#include "tether_monitor/monitor/ensemble/unknown_force.h"

#include <algorithm>

namespace tether_monitor::monitor
{
namespace
{
constexpr double EXPECTED = 2.0;  // standard deviations of what is found
constexpr double LARGEST_FACTOR = 8.0, LEAST_STEP = 1.2;
constexpr double FAST_SHARE = 0.4;  // of the unknown force, that is fast
}  // namespace

UnknownForce unknownForceOf(const Config& config)
{
  UnknownForce force;
  force.slow_stddev = unknownForceStddev(config);
  force.fast_stddev = FAST_SHARE * force.slow_stddev;
  return force;
}

UnknownForce reconsidered(const UnknownForce& told, const UnknownForce& thought, double found)
{
  const double factor = std::clamp(found / (EXPECTED * told.slow_stddev), 1.0, LARGEST_FACTOR);
  const double step = factor * told.slow_stddev / thought.slow_stddev;
  if (step < LEAST_STEP && step > 1.0 / LEAST_STEP && factor > 1.0)
    return thought;
  UnknownForce force = told;
  force.slow_stddev *= factor;
  force.fast_stddev *= factor;
  return force;
}

}  // namespace tether_monitor::monitor
