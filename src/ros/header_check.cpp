#include "tether_monitor/ros/header_check.h"

#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>

#include "tether_monitor/ros/geometry_conversions.h"
#include "tether_monitor/ros/message_bounds.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
HeaderCheck::HeaderCheck(const monitor::TetherEstimator& estimator, const tf2::BufferCore& transforms,
                         const SensorMounts& mounts, const TimeOrigin& time)
  : estimator_(estimator), config_(estimator.config()), transforms_(transforms), mounts_(mounts), time_(time)
{
}

std::optional<InputError> HeaderCheck::checkStamp(const std_msgs::Header& header, const ros::Time& now) const
{
  if (header.stamp.isZero())
    return "header.stamp is zero";
  const double ahead = secondsBetween(header.stamp, now);
  if (ahead > std::min(config_.pose_timeout, mostOf(Field::FUTURE)))
    return "header.stamp is " + std::to_string(ahead) + " s in the future";
  if (-ahead > mostOf(Field::PAST))
    return "header.stamp is " + std::to_string(-ahead) + " s in the past";
  return std::nullopt;
}

std::optional<InputError> HeaderCheck::check(const std_msgs::Header& header, const ros::Time& now,
                                             Eigen::Isometry3d& to_world) const
{
  const std::optional<InputError> stamp = checkStamp(header, now);
  return stamp ? stamp : transformToWorld(header, to_world);
}

geometry_msgs::TransformStamped HeaderCheck::lookUp(const std::string& world, const std_msgs::Header& header) const
{
  try
  {
    return transforms_.lookupTransform(world, header.frame_id, header.stamp);
  }
  catch (const tf2::ExtrapolationException&)
  {
    // A moving frame is usually published a little after the poses in it.
    const geometry_msgs::TransformStamped last = transforms_.lookupTransform(world, header.frame_id, ros::Time());
    if (std::abs(secondsBetween(header.stamp, last.header.stamp)) > config_.pose_timeout)
      throw;
    return last;
  }
}

// Nobody publishes where the vessel is, but we know.
bool HeaderCheck::isOnVessel(const std_msgs::Header& header, Eigen::Isometry3d& transform) const
{
  const std::optional<monitor::BodyState> vessel = estimator_.vessel().bodyAt(time_.seconds(header.stamp));
  Eigen::Isometry3d mount;
  if (!vessel || mounts_.find(config_.vessel, header.frame_id, mount))
    return false;
  transform.linear() = vessel->orientation.toRotationMatrix();
  transform.translation() = vessel->position;
  transform = transform * mount;
  return true;
}

std::optional<InputError> HeaderCheck::transformToWorld(const std_msgs::Header& header,
                                                        Eigen::Isometry3d& transform) const
{
  const std::string& world = config_.world_frame;
  transform.setIdentity();
  if (header.frame_id == world)
    return std::nullopt;
  if (header.frame_id.empty())
    return "header.frame_id is empty (expected '" + world + "')";
  try
  {
    transform = isometry(lookUp(world, header).transform);
    return std::nullopt;
  }
  catch (const tf2::TransformException& error)
  {
    if (isOnVessel(header, transform))
      return std::nullopt;
    if (mounts_.isOn(config_.vessel, header.frame_id))
      return "frame '" + header.frame_id +
             "' is on the vessel, and where that is, height included, is not known yet";
    return "frame '" + header.frame_id + "' cannot be transformed to '" + world + "': " + error.what();
  }
}

}  // namespace tether_monitor
