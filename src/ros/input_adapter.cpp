#include "tether_monitor/ros/input_adapter.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/cable/winch_drum.h"
#include "tether_monitor/ros/geometry_conversions.h"
#include "tether_monitor/ros/message_conversions.h"

namespace tether_monitor
{
namespace
{
using Result = std::optional<InputError>;

Result outOfBounds(const core::Obstacle& obstacle)
{
  Result error = outOfBounds(Field::POSITION, obstacle.position);
  if (!error)
    error = outOfBounds(Field::VELOCITY, obstacle.velocity);
  if (!error)
    error = outOfBounds(Field::OBSTACLE_SIZE, obstacle.size);
  if (!error)
    error = outOfBounds(Field::MASS, obstacle.mass);
  return error ? error : outOfBounds(Field::FRICTION, obstacle.friction);
}
}  // namespace

InputAdapter::InputAdapter(monitor::TetherEstimator& estimator, const tf2::BufferCore& transforms)
  : estimator_(estimator),
    mounts_(transforms),
    headers_(estimator, transforms, mounts_, time_),
    motion_(estimator, headers_, mounts_, time_, fixes_),
    sensors_(estimator, headers_, mounts_, time_, fixes_)
{
}

Result InputAdapter::noted(const Result& error, const ros::Time& now)
{
  if (error)
    estimator_.noteRejectedInput(time_.seconds(now));
  return error;
}

Result InputAdapter::tryLength(double t, double length, double rate)
{
  if (estimator_.addPayout(t, length, rate))
    return std::nullopt;
  const monitor::Config& config = estimator_.config();
  const bool has_layout = !config.layout.sections.empty() || !config.layout.attachments.empty();
  return "length = " + std::to_string(length) + " (must be > 0 m, " +
         (has_layout ? "leave sections and attachments outside, " : "") +
         "change by 4.5 m/s at most, and be later than the last)";
}

Result InputAdapter::accept(const Payout& message, const ros::Time& now)
{
  Result error = headers_.checkStamp(message.header, now);
  if (!error)
    error = outOfBounds(Field::LENGTH, message.length);
  if (!error)
    error = outOfBounds(Field::PAYOUT_RATE, message.rate);
  if (!error)
    error = tryLength(time_.seconds(message.header.stamp), message.length, message.rate);
  return noted(error, now);
}

Result InputAdapter::acceptLength(const std_msgs::Float64& message, const ros::Time& now)
{
  const Result error = outOfBounds(Field::LENGTH, message.data);
  return noted(error ? error : tryLength(time_.seconds(now), message.data, monitor::TetherEstimate::NONE), now);
}

Result InputAdapter::accept(const sensor_msgs::JointState& message, const ros::Time& now)
{
  return noted(tryJoint(message, now), now);
}

Result InputAdapter::tryJoint(const sensor_msgs::JointState& message, const ros::Time& now)
{
  const std::optional<monitor::WinchJointConfig>& joint = estimator_.config().inputs.winch_joint;
  if (!joint)
    return "a JointState, and no payout_joint in the parameters (name, ratio)";
  if (const Result error = headers_.checkStamp(message.header, now))
    return error;
  const auto name = std::find(message.name.begin(), message.name.end(), joint->name);
  if (name == message.name.end())
    return std::nullopt;  // of other joints
  const auto k = static_cast<std::size_t>(name - message.name.begin());
  if (k >= message.position.size())
    return "joint '" + joint->name + "' has no position";
  const double length = joint->offset + joint->ratio * message.position[k];
  const double rate =
      k < message.velocity.size() ? joint->ratio * message.velocity[k] : monitor::TetherEstimate::NONE;
  Result error = outOfBounds(Field::LENGTH, length);
  if (!error && !std::isnan(rate))
    error = outOfBounds(Field::PAYOUT_RATE, rate);
  return error ? error : tryLength(time_.seconds(message.header.stamp), length, rate);
}

Result InputAdapter::acceptTurns(const std_msgs::Float64& message, const ros::Time& now)
{
  return noted(tryTurns(message, now), now);
}

Result InputAdapter::tryTurns(const std_msgs::Float64& message, const ros::Time& now)
{
  const monitor::Config& config = estimator_.config();
  if (!config.winch)
    return "turns of a winch that is not in the parameters (winch)";
  const core::WinchDrum drum(*config.winch, config.tether.diameter);
  if (!(message.data > 0.0 && message.data <= drum.turns()))
    return "turns = " + std::to_string(message.data) + " (must be > 0 and <= " + std::to_string(drum.turns()) +
           ")";
  return tryLength(time_.seconds(now), drum.paidOut(message.data), monitor::TetherEstimate::NONE);
}

Result InputAdapter::acceptTetherTurns(const std_msgs::Float64& message, const ros::Time& now)
{
  return noted(estimator_.setTurns(message.data) ? std::nullopt : Result("turns are not finite"), now);
}

Result InputAdapter::accept(const nav_msgs::Path& message, const ros::Time& now)
{
  return noted(tryPlan(message), now);
}

// Its poses are stamped ahead; the transform of their frame is that of now.
Result InputAdapter::tryPlan(const nav_msgs::Path& message)
{
  Eigen::Isometry3d to_world;
  if (const Result error = headers_.transformToWorld(message.header, to_world))
    return error;
  std::vector<monitor::VesselPlan::Point> points;
  for (const geometry_msgs::PoseStamped& pose : message.poses)
  {
    const core::Vector3 position = to_world * vector(pose.pose.position);
    if (const Result error = outOfBounds(Field::POSITION, position))
      return error;
    points.push_back({time_.seconds(pose.header.stamp), position});
  }
  const std::string problem = estimator_.setPlan(points);
  return problem.empty() ? std::nullopt : Result(problem);
}

Result InputAdapter::acceptPayoutPlan(const Payout& message, const ros::Time& now)
{
  Result error = outOfBounds(Field::PAYOUT_RATE, message.rate);
  if (!error && !std::isnan(message.length))
    error = outOfBounds(Field::LENGTH, message.length);
  if (!error && !estimator_.setPayoutPlan({time_.seconds(message.header.stamp), message.length, message.rate}))
    error = "length = " + std::to_string(message.length) + " (must be >= 0 m, or NaN)";
  return noted(error, now);
}

Result InputAdapter::acceptDepth(const std_msgs::Float64& message, const ros::Time& now)
{
  if (!estimator_.simulation().model.environment().hasSeabed())
    return noted("a depth without environment.seabed in the parameters", now);
  if (const Result error = outOfBounds(Field::DEPTH, message.data))
    return noted(error, now);
  if (!estimator_.setDepth(message.data))
    return noted("depth = " + std::to_string(message.data) + " (must be > 0 m and deeper than the waves)", now);
  return std::nullopt;
}

Result InputAdapter::tryTension(double t, double tension)
{
  if (const Result error = outOfBounds(Field::FORCE, tension))
    return error;
  return errorOf(estimator_.addTension(t, tension));
}

Result InputAdapter::accept(const TensionMeasurement& message, const ros::Time& now)
{
  const Result error = headers_.checkStamp(message.header, now);
  return noted(error ? error : tryTension(time_.seconds(message.header.stamp), message.tension), now);
}

Result InputAdapter::acceptTension(const std_msgs::Float64& message, const ros::Time& now)
{
  return noted(tryTension(time_.seconds(now), message.data), now);
}

Result InputAdapter::accept(const geometry_msgs::Vector3Stamped& message, const ros::Time& now)
{
  Eigen::Isometry3d to_world;
  Result error = headers_.check(message.header, now, to_world);
  if (!error)
    error = errorOf(
        estimator_.addDirection(time_.seconds(message.header.stamp), to_world.linear() * vector(message.vector)));
  return noted(error, now);
}

Result InputAdapter::accept(const geometry_msgs::WrenchStamped& message, const ros::Time& now)
{
  return noted(tryThrust(message, now), now);
}

Result InputAdapter::tryThrust(const geometry_msgs::WrenchStamped& message, const ros::Time& now)
{
  if (const Result error = headers_.checkStamp(message.header, now))
    return error;
  if (!estimator_.vehicle().takesThrust())
    return "thrust on a vehicle that is not simulated (vehicle.mode is tracked)";
  const std::string& frame = estimator_.config().vehicle.frame;
  if (message.header.frame_id != frame && !message.header.frame_id.empty())
    return "frame '" + message.header.frame_id + "' is not the vehicle's ('" + frame + "')";
  core::Wrench thrust{vector(message.wrench.force), vector(message.wrench.torque)};
  if (estimator_.config().vehicle.body_axes == monitor::BodyAxes::FRD)
    thrust = {monitor::turnedAboutX(thrust.force), monitor::turnedAboutX(thrust.torque)};
  Result error = outOfBounds(Field::FORCE, thrust.force);
  if (!error)
    error = outOfBounds(Field::TORQUE, thrust.torque);
  if (error)
    return error;
  estimator_.setThrust(time_.seconds(message.header.stamp), thrust);
  return std::nullopt;
}

Result InputAdapter::accept(const ObstacleArray& message, const ros::Time& now)
{
  return noted(tryObstacles(message, now), now);
}

Result InputAdapter::tryObstacles(const ObstacleArray& message, const ros::Time& now)
{
  Eigen::Isometry3d to_world;
  if (const Result error = headers_.check(message.header, now, to_world))
    return error;
  if (const Result error = outOfBounds(Field::OBSTACLES, message.obstacles.size()))
    return error;
  std::vector<core::Obstacle> obstacles(message.obstacles.size());
  for (std::size_t i = 0; i < obstacles.size(); ++i)
  {
    Result error = toObstacle(message.obstacles[i], to_world, obstacles[i]);
    if (!error)
      error = outOfBounds(obstacles[i]);
    if (error)
      return error;
  }
  const std::vector<std::string> faults = estimator_.setObstacles(time_.seconds(message.header.stamp), obstacles);
  return faults.empty() ? std::nullopt : Result(faults.front());
}

Result InputAdapter::accept(const CurrentProfile& message, const ros::Time& now)
{
  return noted(tryCurrent(message, now), now);
}

Result InputAdapter::tryCurrent(const CurrentProfile& message, const ros::Time& now)
{
  Eigen::Isometry3d to_world;
  if (const Result error = headers_.check(message.header, now, to_world))
    return error;
  if (message.depth.size() != message.velocity.size())
    return "depth has " + std::to_string(message.depth.size()) + " entries, velocity " +
           std::to_string(message.velocity.size());
  if (message.depth.size() > core::CurrentProfile::MOST_SAMPLES)
    return "it has " + std::to_string(message.depth.size()) + " entries, at most " +
           std::to_string(core::CurrentProfile::MOST_SAMPLES) + " can be";
  std::vector<core::CurrentProfile::Sample> samples;
  for (std::size_t i = 0; i < message.depth.size(); ++i)
    samples.push_back({message.depth[i], to_world.linear() * vector(message.velocity[i])});
  for (const core::CurrentProfile::Sample& sample : samples)
  {
    Result error = outOfBounds(Field::WATER_VELOCITY, sample.velocity);
    if (!error)
      error = outOfBounds(Field::DEPTH, sample.depth);
    if (error)
      return error;
  }
  const std::vector<std::string> faults = core::validate(samples);
  if (!faults.empty())
    return faults.front();
  estimator_.setCurrent(core::CurrentProfile(samples));
  return std::nullopt;
}

}  // namespace tether_monitor
