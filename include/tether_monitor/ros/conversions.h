#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Quaternion.h>
#include <geometry_msgs/Transform.h>
#include <geometry_msgs/Vector3.h>
#include <geometry_msgs/WrenchStamped.h>
#include <tether_monitor/AlarmArray.h>
#include <tether_monitor/TetherState.h>

#include <Eigen/Geometry>

#include "tether_monitor/monitor/alarm_set.h"
#include "tether_monitor/monitor/tether_estimate.h"
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

/// A force [N] at a tether end; NaN while there is none.
geometry_msgs::WrenchStamped wrenchMessage(const std_msgs::Header& header, const monitor::TetherEstimate& estimate,
                                           const core::Vector3& force);

AlarmArray toMessage(const monitor::AlarmSet& alarms, const TimeBase& time);

/// Where an alarm stands in its life, for a person: "ACTIVE", "back in limits, not acknowledged".
const char* lifeForPerson(monitor::AlarmState state);

/// One line for a person: "over_tension: 1.12 is above 1 (fraction of the working load) at s = 0 m".
std::string describeForPerson(const monitor::Alarm& alarm);

}  // namespace tether_monitor
