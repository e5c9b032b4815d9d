#pragma once

#include <geometry_msgs/PointStamped.h>
#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/TwistWithCovarianceStamped.h>
#include <nav_msgs/Odometry.h>

#include "tether_monitor/ros/body_input.h"

namespace tether_monitor
{
/// Gives poses and velocities of vessel and vehicle to an estimator. take() returns nothing if the message was
/// accepted, else why it was not.
class MotionInputAdapter : public BodyInput
{
 public:
  using BodyInput::BodyInput;

  Result take(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now, const Source& source);
  Result take(Body body, const geometry_msgs::PoseWithCovarianceStamped& message, const ros::Time& now,
              const Source& source);
  /// A place without attitude.
  Result take(Body body, const geometry_msgs::PointStamped& message, const ros::Time& now, const Source& source);
  /// In the axes of the world, of the body or of a sensor on it.
  Result take(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now, const Source& source);
  Result take(Body body, const geometry_msgs::TwistWithCovarianceStamped& message, const ros::Time& now,
              const Source& source);
  /// Pose in header.frame_id, twist in the body's axes (child_frame_id).
  Result take(Body body, const nav_msgs::Odometry& message, const ros::Time& now, const Source& source);

 private:
  struct Axes
  {
    core::Matrix3 to_world = core::Matrix3::Identity();
    core::Vector3 lever = core::Vector3::Zero();  // from the reference point to the sensor, world axes [m]
  };

  Result readPose(Body body, const std_msgs::Header& header, const geometry_msgs::PoseWithCovariance& message,
                  const ros::Time& now, const Source& source, Eigen::Isometry3d& to_world,
                  monitor::PoseMeasurement& pose) const;
  Result twistAxes(Body body, const std_msgs::Header& header, double t, Axes& axes) const;
};

}  // namespace tether_monitor
