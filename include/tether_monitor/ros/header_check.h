#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <std_msgs/Header.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <optional>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/ros/message_bounds.h"

namespace tether_monitor
{
/// Looks at the stamp of a message and finds the transform of its frame. Every function returns nothing, or what
/// is wrong.
class HeaderCheck
{
 public:
  /// Both must outlive this object.
  HeaderCheck(const monitor::Config& config, const tf2::BufferCore& transforms);

  std::optional<InputError> checkStamp(const std_msgs::Header& header, const ros::Time& now) const;
  /// Stamp and frame of a message. @param to_world  out: the transform of its frame.
  std::optional<InputError> check(const std_msgs::Header& header, const ros::Time& now,
                                  Eigen::Isometry3d& to_world) const;
  /// The frame alone.
  std::optional<InputError> transformToWorld(const std_msgs::Header& header, Eigen::Isometry3d& transform) const;

 private:
  /// Transform at the stamp, or the last one if that is at most pose_timeout away. @throws tf2::TransformException
  geometry_msgs::TransformStamped lookUp(const std::string& world, const std_msgs::Header& header) const;

  const monitor::Config& config_;
  const tf2::BufferCore& transforms_;
};

}  // namespace tether_monitor
