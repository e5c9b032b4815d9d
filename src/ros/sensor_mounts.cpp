#include "tether_monitor/ros/sensor_mounts.h"

#include <tf2/exceptions.h>

#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
bool SensorMounts::isOn(const monitor::BodyConfig& body, const std::string& frame) const
{
  constexpr int DEEPEST = 100;
  std::string at = frame, parent;
  for (int depth = 0; depth < DEEPEST; ++depth)
  {
    if (at == body.frame)
      return true;
    if (!transforms_._getParent(at, ros::Time(), parent))
      return false;
    at = parent;
  }
  return false;
}

std::optional<InputError> SensorMounts::find(const monitor::BodyConfig& body, const std::string& frame,
                                             Eigen::Isometry3d& sensor_to_body) const
{
  sensor_to_body.setIdentity();
  const bool is_turned = body.body_axes == monitor::BodyAxes::FRD;
  if (!frame.empty() && frame != body.frame)
  {
    if (!isOn(body, frame))
      return "frame '" + frame + "' is not on the body: no transform to '" + body.frame +
             "' (publish one, or set frame in inputs)";
    try
    {
      sensor_to_body = isometry(transforms_.lookupTransform(body.frame, frame, ros::Time()).transform);
    }
    catch (const tf2::TransformException& error)
    {
      return "frame '" + frame + "': " + error.what();
    }
  }
  if (is_turned)
    sensor_to_body = Eigen::Isometry3d(monitor::halfTurnAboutX()) * sensor_to_body;
  return std::nullopt;
}

}  // namespace tether_monitor
