#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <std_msgs/Header.h>
#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <optional>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/message_bounds.h"
#include "tether_monitor/ros/sensor_mounts.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/**
 * Looks at the stamp of a message and finds the transform of its frame: from the tree of transforms, or for a
 * frame on the vessel from where that is. Every function returns nothing, or what is wrong.
 */
class HeaderCheck
{
 public:
  /// All must outlive this object.
  HeaderCheck(const monitor::TetherEstimator& estimator, const tf2::BufferCore& transforms,
              const SensorMounts& mounts, const TimeOrigin& time);

  std::optional<InputError> checkStamp(const std_msgs::Header& header, const ros::Time& now) const;
  /// Stamp and frame of a message. @param to_world  out: the transform of its frame.
  std::optional<InputError> check(const std_msgs::Header& header, const ros::Time& now,
                                  Eigen::Isometry3d& to_world) const;
  /// The frame alone.
  std::optional<InputError> transformToWorld(const std_msgs::Header& header, Eigen::Isometry3d& transform) const;

 private:
  /// Transform at the stamp, or the last one if that is at most pose_timeout away. @throws tf2::TransformException
  geometry_msgs::TransformStamped lookUp(const std::string& world, const std_msgs::Header& header) const;

  bool isOnVessel(const std_msgs::Header& header, Eigen::Isometry3d& transform) const;

  const monitor::TetherEstimator& estimator_;
  const monitor::Config& config_;
  const tf2::BufferCore& transforms_;
  const SensorMounts& mounts_;
  const TimeOrigin& time_;
};

}  // namespace tether_monitor
