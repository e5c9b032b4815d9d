#pragma once

#include <ros/ros.h>

#include <string>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/ros/cycle_output.h"

namespace tether_monitor
{
/**
 * **Publishes** where monitor.outputs says so: the tether as a nav_msgs/Path (path), the vessel as a
 * geometry_msgs/PoseWithCovarianceStamped (vessel_pose), and on /tf the frames NAME/vessel_end and
 * NAME/vehicle_end, NAME the node: each at its end, x along the tether away from the body, y horizontal.
 */
class StandardOutputs
{
 public:
  StandardOutputs(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, const monitor::Config& config);

  /// Nothing while there are no numbers.
  void publish(const CycleOutput& output);

 private:
  void publishPath(const std_msgs::Header& header, const monitor::TetherEstimate& e) const;
  void publishVessel(const std_msgs::Header& header, const CycleOutput& output) const;
  void publishFrames(const std_msgs::Header& header, const monitor::TetherEstimate& e) const;

  const monitor::StandardOutputsConfig config_;
  const std::string world_frame_;
  std::string prefix_;  // of the frames
  ros::Publisher path_, vessel_, frames_;
  ros::Time last_frames_;
};

/// From the axes of a frame at an end of the tether to the world. @param away  along the tether, any length > 0.
Eigen::Quaterniond endFrame(const core::Vector3& away);

}  // namespace tether_monitor
