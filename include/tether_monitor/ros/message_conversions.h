#pragma once

#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <tether_monitor/ContactArray.h>
#include <tether_monitor/Obstacle.h>
#include <tether_monitor/ParameterEstimate.h>
#include <tether_monitor/TetherState.h>
#include <tether_monitor/WrenchWithCovarianceStamped.h>

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/monitor/config/body_config.h"
#include "tether_monitor/monitor/ensemble/parameter_report.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// Fills the message from an estimate; every field is written, so `out` may be used again and again.
void toMessage(const monitor::TetherEstimate& estimate, TetherState& out);

/// Contacts of an estimate with the obstacles of its model; `header` is left to the caller.
ContactArray contactsMessage(const monitor::TetherEstimate& estimate,
                             const std::vector<core::Obstacle>& obstacles);

/// An obstacle of a message whose frame is taken to the world by `to_world`. @return what is wrong, or nothing.
std::optional<std::string> toObstacle(const Obstacle& message, const Eigen::Isometry3d& to_world,
                                      core::Obstacle& obstacle);

/// Pose and twist (in the body's axes, as its messages have them) of a simulated vehicle; estimate.has_vehicle
/// must hold.
nav_msgs::Odometry vehicleMessage(const std_msgs::Header& header, const monitor::BodyConfig& body,
                                  const monitor::TetherEstimate& estimate);

/// Force [N] and moment [N m] at a tether end; NaN while there is none.
geometry_msgs::WrenchStamped wrenchMessage(const std_msgs::Header& header, const monitor::TetherEstimate& estimate,
                                           const core::Vector3& force, const core::Vector3& moment);

/// What an ensemble believes of its parameters.
/**
 * Force and moment of the tether on the vehicle in its own axes, about its reference point.
 *
 * @param attitude  of the vehicle, body to world; none: the numbers are NaN. The force may be wrong by the
 * standard deviation of the tension at the vehicle, along every axis.
 */
WrenchWithCovarianceStamped bodyWrenchMessage(const std_msgs::Header& header,
                                              const monitor::TetherEstimate& estimate,
                                              const std::optional<Eigen::Quaterniond>& attitude,
                                              const monitor::BodyConfig& body);
ParameterEstimate toMessage(const std_msgs::Header& header, const std::vector<monitor::ParameterEstimate>& report);

}  // namespace tether_monitor
