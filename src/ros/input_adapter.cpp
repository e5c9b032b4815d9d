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

// Of a body in a message, turned to the world and to the axes of the package; none if it says nothing (all zero).
std::optional<Eigen::Quaterniond> orientationOf(const geometry_msgs::Quaternion& message,
                                                const Eigen::Isometry3d& to_world, const monitor::BodyConfig& body)
{
  const Eigen::Quaterniond q = quaternion(message);
  if (q.coeffs().isZero(0.0))
    return std::nullopt;
  const Eigen::Quaterniond turned = Eigen::Quaterniond(to_world.rotation()) * q;
  return body.body_axes == monitor::BodyAxes::FRD ? turned * monitor::halfTurnAboutX() : turned;
}

// From the axes in which a body's messages are to the world.
Eigen::Isometry3d messageAxesToWorld(const monitor::BodyConfig& body, const Eigen::Quaterniond& orientation)
{
  const bool is_turned = body.body_axes == monitor::BodyAxes::FRD;
  return Eigen::Isometry3d(is_turned ? (orientation * monitor::halfTurnAboutX()).normalized()
                                     : orientation.normalized());
}

// Zeros of which nothing tells how good they are: a field that nobody fills.
bool isUnfilled(const geometry_msgs::TwistWithCovariance& twist)
{
  const auto isZero = [](const geometry_msgs::Vector3& v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; };
  return isZero(twist.twist.linear) && isZero(twist.twist.angular) && block(twist.covariance, 0).isZero(0.0);
}

Result resultOf(monitor::Rejection rejection)
{
  return rejection == monitor::Rejection::NONE ? std::nullopt : Result(describe(rejection));
}

Result outOfBounds(const monitor::TwistMeasurement& rates)
{
  const Result error = tether_monitor::outOfBounds(Field::VELOCITY, rates.velocity);
  return error ? error : tether_monitor::outOfBounds(Field::ANGULAR_VELOCITY, rates.angular_velocity);
}

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
  : estimator_(estimator), headers_(estimator.config(), transforms)
{
}

const monitor::MotionBuffer& InputAdapter::track(Body body) const
{
  return body == Body::VESSEL ? estimator_.vessel().track() : estimator_.vehicle().track();
}

const monitor::BodyConfig& InputAdapter::config(Body body) const
{
  return body == Body::VESSEL ? estimator_.config().vessel : estimator_.config().vehicle;
}

Result InputAdapter::noted(const Result& error, const ros::Time& now)
{
  if (error)
    estimator_.noteRejectedInput(time_.seconds(now));
  return error;
}

Result InputAdapter::accept(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now)
{
  return noted(tryPose(body, message, now), now);
}

Result InputAdapter::tryPose(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now)
{
  Eigen::Isometry3d to_world;
  if (const Result error = headers_.check(message.header, now, to_world))
    return error;
  monitor::PoseMeasurement pose;
  pose.t = time_.seconds(message.header.stamp);
  pose.position = core::Vector3(to_world * vector(message.pose.position));
  if (const Result error = outOfBounds(Field::POSITION, pose.position))
    return error;
  pose.orientation = orientationOf(message.pose.orientation, to_world, config(body));
  return resultOf(body == Body::VESSEL ? estimator_.addVessel(pose) : estimator_.addVehicle(pose));
}

// A velocity log in the body: its axes turn with the body.
Result InputAdapter::bodyAxesToWorld(Body body, const std_msgs::Header& header, const ros::Time& now,
                                     Eigen::Isometry3d& to_world) const
{
  if (header.frame_id != config(body).frame)
    return headers_.check(header, now, to_world);
  if (const Result error = headers_.checkStamp(header, now))
    return error;
  to_world.setIdentity();
  if (config(body).twist_frame == monitor::TwistFrame::WORLD)
    return std::nullopt;
  if (!track(body).hasPose())
    return "a twist in the body's frame before any pose";
  to_world = messageAxesToWorld(config(body), track(body).lastOrientation());
  return std::nullopt;
}

Result InputAdapter::accept(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now)
{
  return noted(tryTwist(body, message, now), now);
}

Result InputAdapter::tryTwist(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now)
{
  Eigen::Isometry3d to_world;
  if (const Result error = bodyAxesToWorld(body, message.header, now, to_world))
    return error;
  monitor::TwistMeasurement rates;
  rates.t = time_.seconds(message.header.stamp);
  rates.velocity = core::Vector3(to_world.linear() * vector(message.twist.linear));
  rates.angular_velocity = to_world.linear() * vector(message.twist.angular);
  if (const Result error = outOfBounds(rates))
    return error;
  return resultOf(body == Body::VESSEL ? estimator_.addVessel(rates) : estimator_.addVehicle(rates));
}

Result InputAdapter::accept(Body body, const nav_msgs::Odometry& message, const ros::Time& now)
{
  return noted(tryOdometry(body, message, now), now);
}

Result InputAdapter::tryOdometry(Body body, const nav_msgs::Odometry& message, const ros::Time& now)
{
  const auto& twist = message.twist.twist;
  Eigen::Isometry3d to_world;
  if (const Result error = headers_.check(message.header, now, to_world))
    return error;
  monitor::PoseMeasurement pose;
  pose.t = time_.seconds(message.header.stamp);
  pose.position = measuredVector(vector(message.pose.pose.position), block(message.pose.covariance, 0), to_world,
                                 NOT_MEASURED_STDDEV);
  if (const Result error = outOfBounds(Field::POSITION, pose.position))
    return error;
  pose.orientation = orientationOf(message.pose.pose.orientation, to_world, config(body));
  const monitor::MeasuredVector angles =
      measuredVector(core::Vector3::Zero(), block(message.pose.covariance, 3), to_world, NOT_MEASURED_ANGLE);
  if (!angles.isComplete())
    pose.orientation.reset();

  const Eigen::Quaterniond orientation = pose.orientation.value_or(track(body).lastOrientation());
  const Eigen::Isometry3d body_to_world = config(body).twist_frame == monitor::TwistFrame::WORLD
                                              ? Eigen::Isometry3d(to_world.rotation())
                                              : messageAxesToWorld(config(body), orientation);
  monitor::TwistMeasurement rates;
  rates.t = pose.t;
  rates.velocity =
      measuredVector(vector(twist.linear), block(message.twist.covariance, 0), body_to_world, NOT_MEASURED_STDDEV);
  rates.angular_velocity = body_to_world.linear() * vector(twist.angular);
  const bool knows_axes = pose.orientation || track(body).hasPose();
  if (rates.velocity.isEmpty() || block(message.twist.covariance, 0).hasNaN() || isUnfilled(message.twist) ||
      !knows_axes)
    return resultOf(body == Body::VESSEL ? estimator_.addVessel(pose) : estimator_.addVehicle(pose));
  if (const Result error = outOfBounds(rates))
    return error;
  return resultOf(body == Body::VESSEL ? estimator_.addVessel(pose, rates) : estimator_.addVehicle(pose, rates));
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

Result InputAdapter::accept(const TensionMeasurement& message, const ros::Time& now)
{
  Result error = headers_.checkStamp(message.header, now);
  if (!error)
    error = outOfBounds(Field::FORCE, message.tension);
  if (!error)
    error = resultOf(estimator_.addTension(time_.seconds(message.header.stamp), message.tension));
  return noted(error, now);
}

Result InputAdapter::accept(const geometry_msgs::Vector3Stamped& message, const ros::Time& now)
{
  Eigen::Isometry3d to_world;
  Result error = headers_.check(message.header, now, to_world);
  if (!error)
    error = resultOf(
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
