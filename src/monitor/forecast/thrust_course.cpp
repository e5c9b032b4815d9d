#include "tether_monitor/monitor/forecast/thrust_course.h"

#include <algorithm>

#include "tether_monitor/monitor/forecast/random_vectors.h"

namespace tether_monitor::monitor
{
ThrustCourse::ThrustCourse(const ThrustReaction& reaction, const core::Vector3& force, const core::Vector3& thrust,
                           double most, RandomNumbers& random)
  : slow_force_(force + reaction.lag()), from_(slow_force_), thrust_(thrust), most_(std::max(most, thrust.norm()))
{
  const ThrustReaction::Share share = reaction.share();
  share_ = (share.mean + share.stddev.cwiseProduct(normals<3>(random))).cwiseMax(0.0).cwiseMin(1.0);
}

core::Vector3 ThrustCourse::advance(double dt, const core::Vector3& force)
{
  slow_force_ = ThrustReaction::smoothed(slow_force_, force, dt);
  const core::Vector3 wanted = thrust_ - share_.cwiseProduct(slow_force_ - from_);
  const double size = wanted.norm();
  return (size > most_ ? core::Vector3(most_ / size * wanted) : wanted) - thrust_;
}

}  // namespace tether_monitor::monitor
