#pragma once

#include <Eigen/Geometry>

#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/cable/end_trajectory.h"

namespace tether_monitor::monitor
{
/// Pose and rates of a body's reference point, world frame.
struct BodyState
{
  core::Vector3 position = core::Vector3::Zero();                   ///< [m]
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, unit.
  core::Vector3 velocity = core::Vector3::Zero();                   ///< [m/s]
  core::Vector3 angular_velocity = core::Vector3::Zero();           ///< [rad/s], world axes.

  /// Position and velocity of a point fixed in the body, `lever` from the reference point in body axes [m].
  core::EndMotion attachmentPoint(const core::Vector3& lever) const;
  /// The reference point of a simulated body that is fixed to a node at `attachment` in body axes [m]; coordinates
  /// of the state.
  static BodyState ofNode(const core::CableState& state, std::size_t node, const core::AttitudeState& attitude,
                          const core::Vector3& attachment);

  template <class Archive>
  void serialize(Archive& a)
  {
    a(position, orientation, velocity, angular_velocity);
  }
};

}  // namespace tether_monitor::monitor
