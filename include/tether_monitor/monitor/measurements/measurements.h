#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "tether_monitor/monitor/measurements/measured_vector.h"

namespace tether_monitor::monitor
{
/// A measured pose of a body's reference point, or a part of one: a height, a place, an attitude.
struct PoseMeasurement
{
  double t = 0.0;                                                                  ///< its stamp [s].
  MeasuredVector position;                                                         ///< world frame [m].
  std::optional<Eigen::Quaterniond> orientation = Eigen::Quaterniond::Identity();  ///< body to world, unit; none:
                                                                                   ///< not measured.
  std::optional<core::Vector3> angular_velocity = std::nullopt;  ///< of an attitude without position, world axes
                                                                 ///< [rad/s]; none: not measured.

  bool isAttitude() const { return position.isEmpty() && orientation; }
  bool isHeight() const { return !position.isMeasured(0) && !position.isMeasured(1) && position.isMeasured(2); }
};

/// Measured rates of a body's reference point, world axes.
struct TwistMeasurement
{
  double t = 0.0;                                          ///< its stamp [s].
  MeasuredVector velocity;                                 ///< [m/s]
  core::Vector3 angular_velocity = core::Vector3::Zero();  ///< [rad/s]
};

}  // namespace tether_monitor::monitor
