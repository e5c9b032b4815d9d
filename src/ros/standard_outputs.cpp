#include "tether_monitor/ros/standard_outputs.h"

#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <nav_msgs/Path.h>
#include <tf2_msgs/TFMessage.h>

#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
namespace
{
constexpr int QUEUE = 10;
constexpr double STEEP = 1e-3;  // horizontal part of a direction that is upright
}  // namespace

Eigen::Quaterniond endFrame(const core::Vector3& away)
{
  const core::Vector3 x = away.normalized();
  const core::Vector3 across = core::Vector3::UnitZ().cross(x);
  const core::Vector3 y = across.norm() > STEEP ? core::Vector3(across.normalized()) : core::Vector3::UnitY();
  const core::Vector3 z = x.cross(y).normalized();
  core::Matrix3 axes;
  axes << x, z.cross(x), z;
  return Eigen::Quaterniond(axes);
}

StandardOutputs::StandardOutputs(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                 const monitor::Config& config)
  : config_(config.runtime.outputs), world_frame_(config.world_frame), prefix_(private_nh.getNamespace() + "/")
{
  ros::NodeHandle handle(nh), own(private_nh);
  prefix_.erase(0, prefix_.find_first_not_of('/'));
  if (config_.path)
    path_ = own.advertise<nav_msgs::Path>("path", QUEUE);
  if (config_.vessel_pose)
    vessel_ = own.advertise<geometry_msgs::PoseWithCovarianceStamped>("vessel/estimate", QUEUE);
  if (config_.tf)
    frames_ = handle.advertise<tf2_msgs::TFMessage>("/tf", QUEUE);
}

void StandardOutputs::publish(const CycleOutput& output)
{
  const monitor::TetherEstimate& e = output.estimate;
  std_msgs::Header header;
  header.stamp = output.stamp;
  header.frame_id = world_frame_;
  if (config_.vessel_pose && output.vessel)
    publishVessel(header, output);
  if (!e.has_stations)
    return;
  if (config_.path)
    publishPath(header, e);
  if (config_.tf && output.stamp != last_frames_)
    publishFrames(header, e);
  last_frames_ = output.stamp;
}

void StandardOutputs::publishPath(const std_msgs::Header& header, const monitor::TetherEstimate& e) const
{
  nav_msgs::Path message;
  message.header = header;
  for (std::size_t k = 0; k < e.stations.position.size(); ++k)
  {
    const std::size_t next = k + 1 < e.stations.position.size() ? k + 1 : k, before = next - 1;
    geometry_msgs::PoseStamped pose;
    pose.header = header;
    pose.pose.position = pointMessage(e.stations.position[k]);
    pose.pose.orientation = quaternionMessage(endFrame(e.stations.position[next] - e.stations.position[before]));
    message.poses.push_back(pose);
  }
  path_.publish(message);
}

void StandardOutputs::publishVessel(const std_msgs::Header& header, const CycleOutput& output) const
{
  geometry_msgs::PoseWithCovarianceStamped message;
  message.header = header;
  message.pose.pose.position = pointMessage(output.vessel->position);
  message.pose.pose.orientation = quaternionMessage(output.vessel->orientation);
  const core::Vector3 variance = output.vessel_stddev.cwiseAbs2();
  setBlock(variance.asDiagonal(), 0, message.pose.covariance);
  vessel_.publish(message);
}

void StandardOutputs::publishFrames(const std_msgs::Header& header, const monitor::TetherEstimate& e) const
{
  const std::vector<core::Vector3>& position = e.stations.position;
  const std::size_t n = position.size();
  tf2_msgs::TFMessage message;
  const auto add = [&](const char* name, const core::Vector3& place, const core::Vector3& away)
  {
    geometry_msgs::TransformStamped transform;
    transform.header = header;
    transform.child_frame_id = prefix_ + name;
    transform.transform.translation = vectorMessage(place);
    transform.transform.rotation = quaternionMessage(endFrame(away));
    message.transforms.push_back(transform);
  };
  add("vessel_end", position[0], position[1] - position[0]);
  add("vehicle_end", position[n - 1], position[n - 2] - position[n - 1]);
  frames_.publish(message);
}

}  // namespace tether_monitor
