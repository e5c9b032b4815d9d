#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <std_msgs/Float64.h>
#include <tether_monitor/CurrentProfile.h>
#include <tether_monitor/ObstacleArray.h>
#include <tether_monitor/Payout.h>
#include <tf2/buffer_core.h>

#include <string>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// Which body a message is about.
enum class Body
{
  VESSEL,
  VEHICLE
};

/**
 * Takes messages into an estimator: checks stamp, frame and numbers, converts, and says what was wrong.
 *
 * Every function returns an empty text if the message was taken, else the reason why it was not. A refused message
 * changes nothing but the estimator's note of a refusal. Used by the node and by the replay of bags.
 */
class InputAdapter
{
 public:
  /// @param transforms  for messages in frames other than the world frame; must outlive this object.
  InputAdapter(monitor::TetherEstimator& estimator, const tf2::BufferCore& transforms);

  /// Sets the epoch of the input clock; before the first message.
  void setTimeBase(const TimeOrigin& base) { time_ = base; }

  std::string accept(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now);
  std::string accept(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now);
  /// Pose in header.frame_id, twist in the body's axes (child_frame_id).
  std::string accept(Body body, const nav_msgs::Odometry& message, const ros::Time& now);
  std::string accept(const Payout& message, const ros::Time& now);
  std::string accept(const CurrentProfile& message, const ros::Time& now);
  std::string accept(const ObstacleArray& message, const ros::Time& now);
  /// Thrust on a simulated vehicle, in its own axes; other frames are refused.
  std::string accept(const geometry_msgs::WrenchStamped& message, const ros::Time& now);
  /// Depth of the sea [m].
  std::string acceptDepth(const std_msgs::Float64& message, const ros::Time& now);
  /// Turns of the winch drum since it was full.
  std::string acceptTurns(const std_msgs::Float64& message, const ros::Time& now);

 private:
  std::string stampProblem(const std_msgs::Header& header, const ros::Time& now) const;
  /// Transform at the stamp, or the last one if that is at most pose_timeout away. @throws tf2::TransformException
  geometry_msgs::TransformStamped lookUp(const std::string& world, const std_msgs::Header& header) const;
  std::string transformToWorld(const std_msgs::Header& header, Eigen::Isometry3d& transform) const;
  std::string acceptLength(double t, double length, double rate);
  std::string refused(const std::string& why, const ros::Time& now);
  using Covariance = nav_msgs::Odometry::_pose_type::_covariance_type;
  /// The same as accept(), with the covariance that the message has, if any; does not note a refusal.
  std::string acceptPose(Body body, const geometry_msgs::PoseStamped& message, const Covariance* covariance,
                         const ros::Time& now);
  template <typename Measurement>
  std::string add(Body body, const Measurement& measurement);
  const monitor::MotionBuffer& track(Body body) const;
  const monitor::BodyConfig& config(Body body) const;

  monitor::TetherEstimator& estimator_;
  const tf2::BufferCore& transforms_;
  TimeOrigin time_;
};

}  // namespace tether_monitor
