#pragma once

#include <ros/ros.h>

#include <Eigen/Geometry>
#include <optional>

#include "tether_monitor/monitor/config/runtime_config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor
{
/**
 * Gives the forces of the tether to a simulator of vessel and vehicle, so that they feel it: doc/simulators.md.
 *
 * **Publishes** geometry_msgs/Wrench every cycle on the topics of BridgeConfig, if there are any; zeros while
 * there is no estimate, lest the simulator keep an old force.
 */
class SimulatorBridge
{
 public:
  SimulatorBridge(ros::NodeHandle nh, const monitor::BridgeConfig& config);

  /// @param attitude  of the vehicle, body to world; none: not known.
  void publish(const monitor::TetherEstimate& estimate, const std::optional<Eigen::Quaterniond>& attitude);

 private:
  ros::Publisher vessel_, vehicle_, vehicle_body_;
};

}  // namespace tether_monitor
