#pragma once

#include <tf2/buffer_core.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "tether_monitor/monitor/config/body_config.h"
#include "tether_monitor/ros/message_bounds.h"

namespace tether_monitor
{
/// Where sensors are on a body, from the transforms between their frames and the body's.
class SensorMounts
{
 public:
  /// @param transforms  must outlive this object.
  explicit SensorMounts(const tf2::BufferCore& transforms) : transforms_(transforms) {}

  /// True if a frame is that of the body, or hangs from it in the tree of transforms.
  bool isOn(const monitor::BodyConfig& body, const std::string& frame) const;
  /**
   * From the axes of a sensor to those of the body (forward, left, up), about its reference point.
   *
   * @param frame  of the sensor; empty: the body's.
   * @return       why it is not known.
   */
  std::optional<InputError> find(const monitor::BodyConfig& body, const std::string& frame,
                                 Eigen::Isometry3d& sensor_to_body) const;

 private:
  const tf2::BufferCore& transforms_;
};

}  // namespace tether_monitor
