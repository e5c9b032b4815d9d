#include "tether_monitor/ros/input_adapter.h"

#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>

#include "tether_monitor/ros/message_conversions.h"

namespace tether_monitor
{
InputAdapter::InputAdapter(monitor::TetherEstimator& estimator, const tf2::BufferCore& transforms)
  : estimator_(estimator), transforms_(transforms)
{
}

const monitor::MotionBuffer& InputAdapter::track(Body body) const
{
  return body == Body::VESSEL ? estimator_.vesselTrack() : estimator_.vehicleTrack();
}

template <typename Measurement>
std::string InputAdapter::add(Body body, const Measurement& measurement)
{
  const monitor::Rejection rejection =
      body == Body::VESSEL ? estimator_.addVessel(measurement) : estimator_.addVehicle(measurement);
  return rejection == monitor::Rejection::NONE ? "" : describe(rejection);
}

namespace
{
// Standard deviations of three rows of a covariance, turned to other axes; NaN where the message tells none (zero,
// as ROS has it, or -1).
core::Vector3 stddevs(const boost::array<double, 36>& covariance, int first, const core::Matrix3& turn)
{
  constexpr double MOST = 1e12;
  core::Matrix3 block;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      block(row, column) = std::clamp(covariance[6 * (first + row) + first + column], -MOST, MOST);
  if (!(block.diagonal().minCoeff() > 0.0))
    return core::Vector3::Constant(monitor::PoseMeasurement::UNTOLD);
  const core::Matrix3 turned = turn * block * turn.transpose();
  return turned.diagonal().cwiseMax(0.0).cwiseSqrt();
}
}  // namespace

const monitor::BodyConfig& InputAdapter::config(Body body) const
{
  return body == Body::VESSEL ? estimator_.config().vessel : estimator_.config().vehicle;
}

std::string InputAdapter::refused(const std::string& why, const ros::Time& now)
{
  if (!why.empty())
    estimator_.noteRejectedInput(time_.seconds(now));
  return why;
}

std::string InputAdapter::stampProblem(const std_msgs::Header& header, const ros::Time& now) const
{
  if (header.stamp.isZero())
    return "header.stamp is zero";
  const double ahead = (header.stamp - now).toSec();
  if (ahead > estimator_.config().pose_timeout)
    return "header.stamp is " + std::to_string(ahead) + " s in the future";
  return "";
}

geometry_msgs::TransformStamped InputAdapter::lookUp(const std::string& world,
                                                     const std_msgs::Header& header) const
{
  try
  {
    return transforms_.lookupTransform(world, header.frame_id, header.stamp);
  }
  catch (const tf2::ExtrapolationException&)
  {
    // A moving frame is usually told a little after the poses in it.
    const geometry_msgs::TransformStamped last = transforms_.lookupTransform(world, header.frame_id, ros::Time());
    if (std::abs((header.stamp - last.header.stamp).toSec()) > estimator_.config().pose_timeout)
      throw;
    return last;
  }
}

std::string InputAdapter::transformToWorld(const std_msgs::Header& header, Eigen::Isometry3d& transform) const
{
  const std::string& world = estimator_.config().world_frame;
  transform.setIdentity();
  if (header.frame_id == world)
    return "";
  if (header.frame_id.empty())
    return "header.frame_id is empty (expected '" + world + "')";
  try
  {
    transform = isometry(lookUp(world, header).transform);
    return "";
  }
  catch (const tf2::TransformException& error)
  {
    return "frame '" + header.frame_id + "' cannot be transformed to '" + world + "': " + error.what();
  }
}

std::string InputAdapter::accept(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now)
{
  return refused(acceptPose(body, message, nullptr, now), now);
}

std::string InputAdapter::acceptPose(Body body, const geometry_msgs::PoseStamped& message,
                                     const Covariance* covariance, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  Eigen::Isometry3d to_world;
  if (why.empty())
    why = transformToWorld(message.header, to_world);
  if (!why.empty())
    return why;
  monitor::PoseMeasurement pose;
  pose.t = time_.seconds(message.header.stamp);
  pose.position = to_world * vector(message.pose.position);
  pose.orientation = Eigen::Quaterniond(to_world.rotation()) * quaternion(message.pose.orientation);
  if (covariance)
  {
    if (std::any_of(covariance->begin(), covariance->end(), [](double c) { return std::isnan(c); }))
      return "its covariance is not a number";
    pose.position_stddev = stddevs(*covariance, 0, to_world.rotation());
    pose.orientation_stddev = stddevs(*covariance, 3, to_world.rotation()).maxCoeff();
  }
  return add(body, pose);
}

std::string InputAdapter::accept(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  Eigen::Isometry3d to_world = Eigen::Isometry3d::Identity();
  if (why.empty() && message.header.frame_id == config(body).frame)
  {
    // A velocity log in the body: its axes turn with the body.
    if (!track(body).hasPose())
      return refused("a twist in the body's frame before any pose", now);
    to_world.linear() = track(body).lastOrientation().toRotationMatrix();
  }
  else if (why.empty())
  {
    why = transformToWorld(message.header, to_world);
  }
  if (why.empty())
  {
    monitor::TwistMeasurement rates;
    rates.t = time_.seconds(message.header.stamp);
    rates.velocity = to_world.linear() * vector(message.twist.linear);
    rates.angular_velocity = to_world.linear() * vector(message.twist.angular);
    why = add(body, rates);
  }
  return refused(why, now);
}

std::string InputAdapter::accept(Body body, const nav_msgs::Odometry& message, const ros::Time& now)
{
  const auto& twist = message.twist.twist;
  if (!vector(twist.linear).allFinite() || !vector(twist.angular).allFinite())
    return refused(describe(monitor::Rejection::NOT_FINITE), now);
  geometry_msgs::PoseStamped pose;
  pose.header = message.header;
  pose.pose = message.pose.pose;
  const std::string why = acceptPose(body, pose, &message.pose.covariance, now);
  if (!why.empty())
    return refused(why, now);
  const Eigen::Quaterniond to_world = track(body).lastOrientation();
  monitor::TwistMeasurement rates;
  rates.t = time_.seconds(message.header.stamp);
  rates.velocity = to_world * vector(twist.linear);
  rates.angular_velocity = to_world * vector(twist.angular);
  rates.velocity_stddev = stddevs(message.twist.covariance, 0, to_world.toRotationMatrix());
  // A twist that says that it was not measured.
  if (estimator_.isVehicleObserved() && rates.velocity_stddev.minCoeff() > monitor::VesselMotionFilter::UNMEASURED)
    return "";
  return refused(add(body, rates), now);
}

std::string InputAdapter::acceptLength(double t, double length, double rate)
{
  if (estimator_.addPayout(t, length, rate))
    return "";
  const monitor::Config& config = estimator_.config();
  if (!config.layout.sections.empty() || !config.layout.attachments.empty())
    return "length = " + std::to_string(length) +
           " (must be > 0 m, leave sections and attachments outside, change by 4.5 m/s at most, and be later than "
           "the last)";
  return "length = " + std::to_string(length) +
         " (must be > 0 m, change by 4.5 m/s at most, and be later than the last)";
}

std::string InputAdapter::acceptTurns(const std_msgs::Float64& message, const ros::Time& now)
{
  const monitor::Config& config = estimator_.config();
  if (!config.winch)
    return refused("turns of a winch that is not in the parameters (winch)", now);
  const core::WinchDrum drum(*config.winch, config.tether.diameter);
  if (!(message.data > 0.0 && message.data <= drum.turns()))
    return refused(
        "turns = " + std::to_string(message.data) + " (must be > 0 and <= " + std::to_string(drum.turns()) + ")",
        now);
  return refused(acceptLength(time_.seconds(now), drum.paidOut(message.data), monitor::TetherEstimate::NONE), now);
}

std::string InputAdapter::acceptDepth(const std_msgs::Float64& message, const ros::Time& now)
{
  if (!estimator_.model().sea().hasSeabed())
    return refused("a depth without environment.seabed in the parameters", now);
  if (!estimator_.setDepth(message.data))
    return refused("depth = " + std::to_string(message.data) + " (must be > 0 m and deeper than the waves)", now);
  return "";
}

std::string InputAdapter::accept(const geometry_msgs::WrenchStamped& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  const core::Wrench thrust{vector(message.wrench.force), vector(message.wrench.torque)};
  const std::string& frame = estimator_.config().vehicle.frame;
  if (why.empty() && !estimator_.isVehicleSimulated())
    why = "thrust on a vehicle that is not simulated (vehicle.mode is tracked)";
  else if (why.empty() && message.header.frame_id != frame && !message.header.frame_id.empty())
    why = "frame '" + message.header.frame_id + "' is not the vehicle's ('" + frame + "')";
  else if (why.empty() && !(thrust.force.allFinite() && thrust.torque.allFinite()))
    why = describe(monitor::Rejection::NOT_FINITE);
  if (why.empty())
    estimator_.setThrust(time_.seconds(message.header.stamp), thrust);
  return refused(why, now);
}

std::string InputAdapter::accept(const ObstacleArray& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  Eigen::Isometry3d to_world;
  if (why.empty())
    why = transformToWorld(message.header, to_world);
  std::vector<core::Obstacle> obstacles;
  for (std::size_t i = 0; i < message.obstacles.size() && why.empty(); ++i)
  {
    obstacles.emplace_back();
    why = toObstacle(message.obstacles[i], to_world, obstacles.back());
  }
  if (why.empty())
  {
    const std::vector<std::string> faults =
        estimator_.setObstacles(time_.seconds(message.header.stamp), obstacles);
    if (!faults.empty())
      why = faults.front();
  }
  return refused(why, now);
}

std::string InputAdapter::accept(const Payout& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  if (why.empty() && !std::isfinite(message.rate))
    why = "rate is not finite";
  if (why.empty())
    why = acceptLength(time_.seconds(message.header.stamp), message.length, message.rate);
  return refused(why, now);
}

std::string InputAdapter::accept(const CurrentProfile& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  Eigen::Isometry3d to_world;
  if (why.empty())
    why = transformToWorld(message.header, to_world);
  if (why.empty() && message.depth.size() != message.velocity.size())
    why = "depth has " + std::to_string(message.depth.size()) + " entries, velocity " +
          std::to_string(message.velocity.size());
  if (!why.empty())
    return refused(why, now);
  std::vector<core::CurrentProfile::Sample> samples;
  for (std::size_t i = 0; i < message.depth.size(); ++i)
    samples.push_back({message.depth[i], to_world.linear() * vector(message.velocity[i])});
  const std::vector<std::string> faults = core::validate(samples);
  if (!faults.empty())
    return refused(faults.front(), now);
  estimator_.setCurrent(core::CurrentProfile(samples));
  return "";
}

}  // namespace tether_monitor
