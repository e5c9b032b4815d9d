#pragma once

#include <ros/time.h>
#include <tether_monitor/ContactArray.h>
#include <tether_monitor/ParameterEstimate.h>

#include <Eigen/Geometry>
#include <memory>
#include <optional>

#include "tether_monitor/monitor/alarms/alarm_set.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// What a cycle leaves to be published.
struct CycleOutput
{
  ros::Time stamp;
  TimeOrigin time;
  double step_time = 0.0;  ///< computing time of the cycle [s].
  bool over_tension = true;
  monitor::TetherEstimate estimate;
  std::shared_ptr<const monitor::AlarmSet> alarms;      ///< null: nothing new.
  std::optional<ContactArray> contacts;                 ///< none: nothing is touched, and that was said.
  std::optional<ParameterEstimate> parameters;          ///< once a second.
  std::optional<Eigen::Quaterniond> attitude;           ///< of the vehicle, body to world.
  std::optional<monitor::BodyState> vessel;             ///< where it is; none: not known.
  core::Vector3 vessel_stddev = core::Vector3::Zero();  ///< of its position [m]; zero: not known.
  ros::WallTime received;  ///< when the newest message came that it uses; zero: none came.
};

}  // namespace tether_monitor
