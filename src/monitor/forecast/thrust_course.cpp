#include "tether_monitor/monitor/forecast/thrust_course.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/forecast/random_vectors.h"

namespace tether_monitor::monitor
{
ThrustCourse::ThrustCourse(const ThrustReaction& reaction, const core::Vector3& force, const core::Vector3& thrust,
                           double most, RandomNumbers& random)
  : share_(
        (reaction.share() + reaction.shareStddev().cwiseProduct(normals<3>(random))).cwiseMax(0.0).cwiseMin(1.0)),
    slow_force_(force + reaction.lag()),
    from_(slow_force_),
    thrust_(thrust),
    most_(std::max(most, thrust.norm()))
{
}

core::Vector3 ThrustCourse::advance(double dt, const core::Vector3& force)
{
  slow_force_ += (1.0 - std::exp(-dt / ThrustReaction::RESPONSE)) * (force - slow_force_);
  const core::Vector3 wanted = thrust_ - share_.cwiseProduct(slow_force_ - from_);
  const double size = wanted.norm();
  return (size > most_ ? core::Vector3(most_ / size * wanted) : wanted) - thrust_;
}

}  // namespace tether_monitor::monitor
