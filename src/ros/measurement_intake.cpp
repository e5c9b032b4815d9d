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

std::string MeasurementIntake::take(const Payout& message, const ros::Time& now)
{
  std::string why = stampProblem(message.header, now);
  if (why.empty() && !std::isfinite(message.rate))
    why = "rate is not finite";
  if (why.empty() && !estimator_.setPayout(message.length, message.rate))
    why = "length = " + std::to_string(message.length) + " (must be > 0 m)";
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
