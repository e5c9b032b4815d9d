#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <tether_monitor/AlarmArray.h>
#include <tether_monitor/ContactArray.h>
#include <tether_monitor/Obstacle.h>
#include <tether_monitor/TetherState.h>

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "tether_monitor/monitor/alarms/alarm_set.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
Eigen::Vector3d vector(const geometry_msgs::Point& p);
Eigen::Vector3d vector(const geometry_msgs::Vector3& v);
/// Not normalised: the track checks it.
Eigen::Quaterniond quaternion(const geometry_msgs::Quaternion& q);
Eigen::Isometry3d isometry(const geometry_msgs::Transform& transform);
geometry_msgs::Point pointMessage(const Eigen::Vector3d& v);
geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v);

/// Fills the message from an estimate; every field is written, so `out` may be used again and again.
void toMessage(const monitor::TetherEstimate& estimate, TetherState& out);

/// Contacts of an estimate with the obstacles of its model; `header` is left to the caller.
ContactArray contactsMessage(const monitor::TetherEstimate& estimate,
                             const std::vector<core::Obstacle>& obstacles);

/// An obstacle of a message whose frame is taken to the world by `to_world`. @return what is wrong, or "".
std::string toObstacle(const Obstacle& message, const Eigen::Isometry3d& to_world, core::Obstacle& obstacle);

/// Pose and twist (in the body's axes) of a simulated vehicle; estimate.has_vehicle must hold.
nav_msgs::Odometry vehicleMessage(const std_msgs::Header& header, const std::string& child_frame,
                                  const monitor::TetherEstimate& estimate);

geometry_msgs::Quaternion quaternionMessage(const Eigen::Quaterniond& q);

/// A force [N] at a tether end; NaN while there is none.
geometry_msgs::WrenchStamped wrenchMessage(const std_msgs::Header& header, const monitor::TetherEstimate& estimate,
                                           const core::Vector3& force);

AlarmArray toMessage(const monitor::AlarmSet& alarms, const TimeOrigin& time);

/// Where an alarm stands in its life, for a person: "ACTIVE", "back in limits, not acknowledged".
const char* alarmStateText(monitor::AlarmState state);

/// One line for a person: "over_tension: 1.12 is above 1 (fraction of the working load) at s = 0 m".
std::string alarmText(const monitor::Alarm& alarm);

}  // namespace tether_monitor
