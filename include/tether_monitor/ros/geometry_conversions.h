#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>

#include <Eigen/Geometry>
#include <boost/array.hpp>

#include "tether_monitor/monitor/measurements/measured_vector.h"

namespace tether_monitor
{
/// Standard deviations in a message from which on something was not measured: metres and metres a second, radians.
constexpr double NOT_MEASURED_STDDEV = 100.0;
constexpr double NOT_MEASURED_ANGLE = 1.0;
/// Variance with which a message says so.
constexpr double NOT_MEASURED_VARIANCE = 1e6;

Eigen::Vector3d vector(const geometry_msgs::Point& p);
Eigen::Vector3d vector(const geometry_msgs::Vector3& v);
/// Not normalised: the track checks it.
Eigen::Quaterniond quaternion(const geometry_msgs::Quaternion& q);
Eigen::Isometry3d isometry(const geometry_msgs::Transform& transform);
/// A turn alone.
inline Eigen::Isometry3d isometry(const core::Matrix3& rotation)
{
  return Eigen::Isometry3d(rotation);
}
geometry_msgs::Point pointMessage(const Eigen::Vector3d& v);
geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v);
geometry_msgs::Quaternion quaternionMessage(const Eigen::Quaterniond& q);

/// A diagonal block of a covariance: of the linear part (first = 0) or the angular one (first = 3). Symmetric.
core::Matrix3 block(const boost::array<double, 36>& covariance, int first);
/// A covariance of three numbers, symmetric.
core::Matrix3 block(const boost::array<double, 9>& covariance);
void setBlock(const core::Matrix3& block, int first, boost::array<double, 36>& covariance);

/**
 * A vector of a message in the axes of the world.
 *
 * A variance of zero or below, as ROS has it, or none at all (NaN) says nothing of an axis: its accuracy is
 * unspecified. One of `not_measured` squared or more says that the axis was not measured. Turned to the world, an
 * axis is as poor as the poorest that it is made of.
 */
monitor::MeasuredVector measuredVector(const core::Vector3& value, const core::Matrix3& covariance,
                                       const Eigen::Isometry3d& to_world, double not_measured);

}  // namespace tether_monitor
