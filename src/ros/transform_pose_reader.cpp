#include "tether_monitor/ros/transform_pose_reader.h"

#include <tf2/exceptions.h>

#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
TransformPoseReader::TransformPoseReader(const monitor::Config& config, const tf2::BufferCore& transforms)
  : world_(config.world_frame),
    vessel_(config.vessel.tf_frame),
    vehicle_(config.vehicle.tf_frame),
    transforms_(transforms)
{
}

std::optional<InputError> TransformPoseReader::find(Body body, const ros::Time& stamp,
                                                    geometry_msgs::PoseStamped& pose) const
{
  try
  {
    const geometry_msgs::TransformStamped found = transforms_.lookupTransform(world_, frame(body), stamp);
    pose.header = found.header;
    pose.pose.position = pointMessage(vector(found.transform.translation));
    pose.pose.orientation = found.transform.rotation;
    return std::nullopt;
  }
  catch (const tf2::TransformException& error)
  {
    return error.what();
  }
}

void TransformPoseReader::read(InputAdapter& adapter, const ros::Time& now,
                               const std::function<void(const std::string&, const InputError&)>& refuse)
{
  for (const Body body : {Body::VESSEL, Body::VEHICLE})
  {
    ros::Time& last = body == Body::VESSEL ? last_vessel_ : last_vehicle_;
    geometry_msgs::PoseStamped pose;
    if (frame(body).empty() || find(body, ros::Time(), pose))
      continue;  // not there yet: the status says that nothing has come
    if (pose.header.stamp.isZero())
      pose.header.stamp = now;  // of transforms that never change
    if (!(pose.header.stamp > last))
      continue;
    last = pose.header.stamp;
    if (const std::optional<InputError> error = adapter.accept(body, pose, now))
      refuse("/tf: " + frame(body), *error);
  }
}

}  // namespace tether_monitor
