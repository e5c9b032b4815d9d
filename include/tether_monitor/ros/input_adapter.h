#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <geometry_msgs/TwistStamped.h>
#include <geometry_msgs/Vector3Stamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <nav_msgs/Path.h>
#include <std_msgs/Float64.h>
#include <tether_monitor/CurrentProfile.h>
#include <tether_monitor/ObstacleArray.h>
#include <tether_monitor/Payout.h>
#include <tether_monitor/TensionMeasurement.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/header_check.h"
#include "tether_monitor/ros/message_bounds.h"
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
 * Gives messages to an estimator: checks stamp, frame and numbers, converts, and says what was wrong.
 *
 * Every function returns nothing if the message was accepted, else why it was not. A refused message changes
 * nothing but the estimator's note of a refusal. Used by the node and by the replay of bags.
 */
class InputAdapter
{
 public:
  /// @param transforms  for messages in frames other than the world frame; must outlive this object.
  InputAdapter(monitor::TetherEstimator& estimator, const tf2::BufferCore& transforms);

  /// Sets the epoch of the input clock; before the first message.
  void setTimeBase(const TimeOrigin& base) { time_ = base; }

  std::optional<InputError> accept(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now);
  std::optional<InputError> accept(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now);
  /// Pose in header.frame_id, twist in the body's axes (child_frame_id).
  std::optional<InputError> accept(Body body, const nav_msgs::Odometry& message, const ros::Time& now);
  std::optional<InputError> accept(const Payout& message, const ros::Time& now);
  /// Load cell at the vessel end.
  std::optional<InputError> accept(const TensionMeasurement& message, const ros::Time& now);
  /// Direction in which the tether leaves the vessel, any length, in mode observed.
  std::optional<InputError> accept(const geometry_msgs::Vector3Stamped& message, const ros::Time& now);
  std::optional<InputError> accept(const CurrentProfile& message, const ros::Time& now);
  std::optional<InputError> accept(const ObstacleArray& message, const ros::Time& now);
  /// Thrust on a simulated vehicle, in its own axes; other frames are refused.
  std::optional<InputError> accept(const geometry_msgs::WrenchStamped& message, const ros::Time& now);
  /// Depth of the sea [m].
  std::optional<InputError> acceptDepth(const std_msgs::Float64& message, const ros::Time& now);
  /// Turns of the winch drum since it was full.
  std::optional<InputError> acceptTurns(const std_msgs::Float64& message, const ros::Time& now);
  /// Turns of the tether about itself, as a pilot has counted them.
  std::optional<InputError> acceptTetherTurns(const std_msgs::Float64& message, const ros::Time& now);
  /// Where the vessel is meant to go; every pose with its stamp.
  std::optional<InputError> accept(const nav_msgs::Path& message, const ros::Time& now);
  /// What the winch is meant to do from the stamp on.
  std::optional<InputError> acceptPayoutPlan(const Payout& message, const ros::Time& now);

 private:
  std::optional<InputError> noted(const std::optional<InputError>& error, const ros::Time& now);
  std::optional<InputError> bodyAxesToWorld(Body body, const std_msgs::Header& header, const ros::Time& now,
                                            Eigen::Isometry3d& to_world) const;

  std::optional<InputError> tryTwist(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now);
  std::optional<InputError> tryOdometry(Body body, const nav_msgs::Odometry& message, const ros::Time& now);
  std::optional<InputError> tryPose(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now);
  std::optional<InputError> tryThrust(const geometry_msgs::WrenchStamped& message, const ros::Time& now);
  std::optional<InputError> tryObstacles(const ObstacleArray& message, const ros::Time& now);
  std::optional<InputError> tryCurrent(const CurrentProfile& message, const ros::Time& now);
  std::optional<InputError> tryPlan(const nav_msgs::Path& message);
  std::optional<InputError> tryTurns(const std_msgs::Float64& message, const ros::Time& now);
  std::optional<InputError> tryLength(double t, double length, double rate);

  const monitor::MotionBuffer& track(Body body) const;
  const monitor::BodyConfig& config(Body body) const;

  monitor::TetherEstimator& estimator_;
  HeaderCheck headers_;
  TimeOrigin time_;
};

}  // namespace tether_monitor
