#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <tf2/buffer_core.h>

#include <functional>
#include <optional>
#include <string>

#include "tether_monitor/ros/input_adapter.h"

namespace tether_monitor
{
/**
 * Reads the pose of a body from the tree of transforms, where vessel.tf_frame or vehicle.tf_frame says so.
 */
class TransformPoseReader
{
 public:
  /// @param transforms  must outlive this object.
  TransformPoseReader(const monitor::Config& config, const tf2::BufferCore& transforms);

  /// The frame that is looked up for a body; empty: none.
  const std::string& frame(Body body) const { return body == Body::VESSEL ? vessel_ : vehicle_; }
  /// The pose in the world frame. @param stamp  zero: the last one. @return what is wrong.
  std::optional<InputError> find(Body body, const ros::Time& stamp, geometry_msgs::PoseStamped& pose) const;
  /**
   * Gives every pose that is newer than the last to the adapter.
   *
   * @param refuse  called with the name of the frame and the reason.
   */
  void read(InputAdapter& adapter, const ros::Time& now,
            const std::function<void(const std::string&, const InputError&)>& refuse);
  /// Time has gone back.
  void clear() { last_vessel_ = last_vehicle_ = ros::Time(); }

 private:
  std::string world_, vessel_, vehicle_;
  const tf2::BufferCore& transforms_;
  ros::Time last_vessel_, last_vehicle_;
};

}  // namespace tether_monitor
