#pragma once

#include <Eigen/Geometry>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// Attitude of a simulated body at a tether end, in its own axes. Its position is that of the end node.
struct AttitudeState
{
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< body to world, unit.
  Vector3 velocity = Vector3::Zero();                               ///< angular, body axes [rad/s].
  Vector3 acceleration = Vector3::Zero();                           ///< angular, body axes [rad/s^2].
  Vector3 algorithmic_acceleration = Vector3::Zero();               ///< see CableState.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(orientation, velocity, acceleration, algorithmic_acceleration);
  }
};

}  // namespace tether_monitor::core
