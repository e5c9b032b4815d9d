#pragma once

#include <geometry_msgs/Vector3Stamped.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/JointState.h>
#include <std_msgs/Float64.h>
#include <tether_monitor/CurrentProfile.h>
#include <tether_monitor/ObstacleArray.h>
#include <tether_monitor/Payout.h>
#include <tether_monitor/TensionMeasurement.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <type_traits>

#include "tether_monitor/ros/motion_input_adapter.h"
#include "tether_monitor/ros/sensor_input_adapter.h"

namespace tether_monitor
{
/// True for the messages that MotionInputAdapter takes.
template <typename Message, typename = void>
struct IsMotion : std::false_type
{
};
template <typename Message>
struct IsMotion<Message, std::void_t<decltype(std::declval<MotionInputAdapter&>().take(
                             Body(), std::declval<const Message&>(), ros::Time(), monitor::SourceConfig()))>>
  : std::true_type
{
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
  /// Of the vehicle, for those who look at them.
  const RecentFixes& fixes() const { return fixes_; }
  /// The clock has jumped.
  void clearFixes() { fixes_.clear(); }

  /// Of the motion of a body: what MotionInputAdapter or SensorInputAdapter takes.
  template <typename Message>
  std::optional<InputError> accept(Body body, const Message& message, const ros::Time& now,
                                   const monitor::SourceConfig& source = monitor::SourceConfig())
  {
    if constexpr (IsMotion<Message>::value)
      return noted(motion_.take(body, message, now, source), now);
    else
      return noted(sensors_.take(body, message, now, source), now);
  }
  std::optional<InputError> accept(const Payout& message, const ros::Time& now);
  /// A winch whose joint is in the parameters (payout_joint); others in the message do not matter.
  std::optional<InputError> accept(const sensor_msgs::JointState& message, const ros::Time& now);
  /// Deployed length [m], as it is now.
  std::optional<InputError> acceptLength(const std_msgs::Float64& message, const ros::Time& now);
  /// Load cell at the vessel end [N], as it is now.
  std::optional<InputError> acceptTension(const std_msgs::Float64& message, const ros::Time& now);
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
  std::optional<InputError> tryThrust(const geometry_msgs::WrenchStamped& message, const ros::Time& now);
  std::optional<InputError> tryObstacles(const ObstacleArray& message, const ros::Time& now);
  std::optional<InputError> tryCurrent(const CurrentProfile& message, const ros::Time& now);
  std::optional<InputError> tryPlan(const nav_msgs::Path& message);
  std::optional<InputError> tryTurns(const std_msgs::Float64& message, const ros::Time& now);
  std::optional<InputError> tryLength(double t, double length, double rate);

  std::optional<InputError> tryJoint(const sensor_msgs::JointState& message, const ros::Time& now);
  std::optional<InputError> tryTension(double t, double tension);

  monitor::TetherEstimator& estimator_;
  TimeOrigin time_;
  SensorMounts mounts_;
  HeaderCheck headers_;
  RecentFixes fixes_;
  MotionInputAdapter motion_;
  SensorInputAdapter sensors_;
};

}  // namespace tether_monitor
