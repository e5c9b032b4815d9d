#include "tether_monitor/ros/simulator_bridge.h"

#include <geometry_msgs/Wrench.h>

#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
namespace
{
constexpr int QUEUE = 2;

geometry_msgs::Wrench wrenchOf(const core::Vector3& force, const core::Vector3& torque, bool is_valid)
{
  geometry_msgs::Wrench wrench;
  if (is_valid)
  {
    wrench.force = vectorMessage(force);
    wrench.torque = vectorMessage(torque);
  }
  return wrench;
}

void send(const ros::Publisher& publisher, const core::Vector3& force, const core::Vector3& torque, bool is_valid)
{
  if (publisher)
    publisher.publish(wrenchOf(force, torque, is_valid));
}
}  // namespace

SimulatorBridge::SimulatorBridge(ros::NodeHandle nh, const monitor::BridgeConfig& config)
{
  const auto advertise = [&](const std::string& topic)
  { return topic.empty() ? ros::Publisher() : nh.advertise<geometry_msgs::Wrench>(topic, QUEUE); };
  vessel_ = advertise(config.vessel);
  vehicle_ = advertise(config.vehicle);
  vehicle_body_ = advertise(config.vehicle_body);
}

void SimulatorBridge::publish(const monitor::TetherEstimate& e, const std::optional<Eigen::Quaterniond>& attitude)
{
  const core::EndForces& ends = e.stations.ends;
  send(vessel_, ends.vessel, ends.vessel_moment, e.has_stations);
  send(vehicle_, ends.vehicle, ends.vehicle_moment, e.has_stations);
  const Eigen::Quaterniond to_body = attitude.value_or(Eigen::Quaterniond::Identity()).conjugate();
  send(vehicle_body_, to_body * ends.vehicle, to_body * ends.vehicle_moment, e.has_stations && attitude);
}

}  // namespace tether_monitor
