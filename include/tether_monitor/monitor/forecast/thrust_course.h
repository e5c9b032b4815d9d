#pragma once

#include "tether_monitor/monitor/ensemble/random_numbers.h"
#include "tether_monitor/monitor/forecast/thrust_reaction.h"

namespace tether_monitor::monitor
{
/// The thrust with which one vehicle answers its tether from a time on.
class ThrustCourse
{
 public:
  /// @param force  of the tether on this vehicle at the beginning, world [N]. @param thrust  world [N].
  /// @param most  largest thrust that can be [N].
  ThrustCourse(const ThrustReaction& reaction, const core::Vector3& force, const core::Vector3& thrust,
               double most, RandomNumbers& random);
  /// The next step. @param force  of the tether now, world [N]. @return what comes on top of the thrust [N].
  core::Vector3 advance(double dt, const core::Vector3& force);

 private:
  core::Vector3 share_, slow_force_, from_, thrust_;
  double most_;
};

}  // namespace tether_monitor::monitor
