#include "tether_monitor/ros/measurement_intake.h"

#include <tf2/exceptions.h>

#include <cmath>

#include "tether_monitor/ros/conversions.h"

namespace tether_monitor
{
MeasurementIntake::MeasurementIntake(monitor::TetherEstimator& estimator, const tf2::BufferCore& transforms)
  : estimator_(estimator), transforms_(transforms)
{
}

monitor::BodyTrack& MeasurementIntake::track(BodyName body)
{
  return body == BodyName::VESSEL ? estimator_.vessel() : estimator_.vehicle();
}

const monitor::BodyConfig& MeasurementIntake::config(BodyName body) const
{
  return body == BodyName::VESSEL ? estimator_.config().vessel : estimator_.config().vehicle;
}

std::string MeasurementIntake::refused(const std::string& why, const ros::Time& now)
{
  if (!why.empty())
    estimator_.noteRejectedInput(time_.seconds(now));
  return why;
}

std::string MeasurementIntake::stampProblem(const std_msgs::Header& header, const ros::Time& now) const
{
  if (header.stamp.isZero())
    return "header.stamp is zero";
  const double ahead = (header.stamp - now).toSec();
  if (ahead > estimator_.config().pose_timeout)
    return "header.stamp is " + std::to_string(ahead) + " s in the future";
  return "";
}

geometry_msgs::TransformStamped MeasurementIntake::lookUp(const std::string& world,
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

std::string MeasurementIntake::transformToWorld(const std_msgs::Header& header, Eigen::Isometry3d& transform) const
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

std::string MeasurementIntake::take(BodyName body, const geometry_msgs::PoseStamped& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  Eigen::Isometry3d to_world;
  if (why.empty())
    why = transformToWorld(message.header, to_world);
  if (why.empty())
  {
    const monitor::Rejection rejection =
        track(body).addPose(time_.seconds(message.header.stamp), to_world * vector(message.pose.position),
                            Eigen::Quaterniond(to_world.rotation()) * quaternion(message.pose.orientation));
    if (rejection != monitor::Rejection::NONE)
      why = describe(rejection);
  }
  return refused(why, now);
}

std::string MeasurementIntake::take(BodyName body, const geometry_msgs::TwistStamped& message,
                                    const ros::Time& now)
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
    const monitor::Rejection rejection =
        track(body).addRates(time_.seconds(message.header.stamp), to_world.linear() * vector(message.twist.linear),
                             to_world.linear() * vector(message.twist.angular));
    if (rejection != monitor::Rejection::NONE)
      why = describe(rejection);
  }
  return refused(why, now);
}

std::string MeasurementIntake::take(BodyName body, const nav_msgs::Odometry& message, const ros::Time& now)
{
  const auto& twist = message.twist.twist;
  if (!vector(twist.linear).allFinite() || !vector(twist.angular).allFinite())
    return refused(describe(monitor::Rejection::NOT_FINITE), now);
  geometry_msgs::PoseStamped pose;
  pose.header = message.header;
  pose.pose = message.pose.pose;
  std::string why = take(body, pose, now);
  if (!why.empty())
    return why;
  const Eigen::Quaterniond to_world = track(body).lastOrientation();
  const monitor::Rejection rejection = track(body).addRates(
      time_.seconds(message.header.stamp), to_world * vector(twist.linear), to_world * vector(twist.angular));
  return refused(rejection == monitor::Rejection::NONE ? "" : describe(rejection), now);
}

std::string MeasurementIntake::takeLength(double t, double length, double rate)
{
  if (estimator_.addPayout(t, length, rate))
    return "";
  const monitor::Config& config = estimator_.config();
  if (!config.fittings.sections.empty() || !config.fittings.attachments.empty())
    return "length = " + std::to_string(length) +
           " (must be > 0 m, leave sections and attachments outside, change by 4.5 m/s at most, and be later than "
           "the last)";
  return "length = " + std::to_string(length) +
         " (must be > 0 m, change by 4.5 m/s at most, and be later than the last)";
}

std::string MeasurementIntake::takeTurns(const std_msgs::Float64& message, const ros::Time& now)
{
  const monitor::Config& config = estimator_.config();
  if (!config.winch)
    return refused("turns of a winch that is not in the parameters (winch)", now);
  const core::WinchDrum drum(*config.winch, config.tether.diameter);
  if (!(message.data > 0.0 && message.data <= drum.turns()))
    return refused(
        "turns = " + std::to_string(message.data) + " (must be > 0 and <= " + std::to_string(drum.turns()) + ")",
        now);
  return refused(takeLength(time_.seconds(now), drum.paidOut(message.data), monitor::TetherEstimate::NONE), now);
}

std::string MeasurementIntake::takeDepth(const std_msgs::Float64& message, const ros::Time& now)
{
  if (!estimator_.model().sea().hasSeabed())
    return refused("a depth without environment.seabed in the parameters", now);
  if (!estimator_.setDepth(message.data))
    return refused("depth = " + std::to_string(message.data) + " (must be > 0 m and deeper than the waves)", now);
  return "";
}

std::string MeasurementIntake::take(const geometry_msgs::WrenchStamped& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  const core::Wrench thrust{vector(message.wrench.force), vector(message.wrench.torque)};
  const std::string& frame = estimator_.config().vehicle.frame;
  if (why.empty() && !estimator_.isVehicleFree())
    why = "thrust on a vehicle that is not simulated (vehicle.mode is not free)";
  else if (why.empty() && message.header.frame_id != frame && !message.header.frame_id.empty())
    why = "frame '" + message.header.frame_id + "' is not the vehicle's ('" + frame + "')";
  else if (why.empty() && !(thrust.force.allFinite() && thrust.torque.allFinite()))
    why = describe(monitor::Rejection::NOT_FINITE);
  if (why.empty())
    estimator_.setThrust(time_.seconds(message.header.stamp), thrust);
  return refused(why, now);
}

std::string MeasurementIntake::take(const ObstacleArray& message, const ros::Time& now)
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

std::string MeasurementIntake::take(const Payout& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  if (why.empty() && !std::isfinite(message.rate))
    why = "rate is not finite";
  if (why.empty())
    why = takeLength(time_.seconds(message.header.stamp), message.length, message.rate);
  return refused(why, now);
}

std::string MeasurementIntake::take(const CurrentProfile& message, const ros::Time& now)
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
  const std::vector<std::string> faults = core::problems(samples);
  if (!faults.empty())
    return refused(faults.front(), now);
  estimator_.setCurrent(core::CurrentProfile(samples));
  return "";
}

}  // namespace tether_monitor
