#include "tether_monitor/monitor/measurements/body_state.h"

namespace tether_monitor::monitor
{
BodyState BodyState::ofNode(const core::CableState& state, std::size_t node, const core::AttitudeState& rotation,
                            const core::Vector3& attachment)
{
  BodyState body;
  const core::Vector3 lever = rotation.orientation * attachment;
  body.orientation = rotation.orientation;
  body.angular_velocity = rotation.orientation * rotation.velocity;
  body.position = state.q[node].head<3>() - lever;
  body.velocity = state.v[node].head<3>() - body.angular_velocity.cross(lever);
  return body;
}

core::EndMotion BodyState::attachmentPoint(const core::Vector3& lever) const
{
  const core::Vector3 arm = orientation * lever;
  return {position + arm, velocity + angular_velocity.cross(arm)};
}

}  // namespace tether_monitor::monitor
