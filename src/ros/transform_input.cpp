#include "tether_monitor/ros/transform_input.h"

#include <cmath>
#include <exception>

#include "tether_monitor/monitor/measurements/rejection.h"
#include "tether_monitor/ros/geometry_conversions.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
namespace
{
constexpr double FARTHEST_AHEAD = 1.0;        // [s]
constexpr std::uint32_t LATEST = 4294960000;  // [s]: tf2 adds its memory to a stamp

std::optional<InputError> check(const geometry_msgs::TransformStamped& transform, bool is_static,
                                const ros::Time& now)
{
  if (transform.header.frame_id.empty() || transform.child_frame_id.empty())
    return "a frame without a name";
  if (transform.header.frame_id == transform.child_frame_id)
    return "both frames are the same";
  const Eigen::Quaterniond q = quaternion(transform.transform.rotation);
  if (const auto error = outOfBounds(Field::POSITION, vector(transform.transform.translation)))
    return error;
  if (!(std::abs(q.norm() - 1.0) < 0.01))
    return describe(monitor::Rejection::BAD_QUATERNION);
  if (transform.header.stamp.sec >= LATEST)
    return "its stamp is the end of time";
  if (!is_static && !now.isZero() && secondsBetween(transform.header.stamp, now) > FARTHEST_AHEAD)
    return "its stamp is " + std::to_string(secondsBetween(transform.header.stamp, now)) + " s in the future";
  return std::nullopt;
}
}  // namespace

std::optional<InputError> addTransforms(const tf2_msgs::TFMessage& message, bool is_static, const ros::Time& now,
                                        tf2::BufferCore& buffer)
{
  std::optional<InputError> first;
  for (const geometry_msgs::TransformStamped& transform : message.transforms)
  {
    std::optional<InputError> error = check(transform, is_static, now);
    try
    {
      if (!error)
        buffer.setTransform(transform, "tether_monitor", is_static);
    }
    catch (const std::exception& thrown)
    {
      error = thrown.what();
    }
    if (error && !first)
      first =
          "transform from '" + transform.header.frame_id + "' to '" + transform.child_frame_id + "': " + *error;
  }
  return first;
}

}  // namespace tether_monitor
