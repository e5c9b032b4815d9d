#pragma once

#include <ros/ros.h>
#include <tether_monitor/AlarmArray.h>
#include <tether_monitor/AlarmEvent.h>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// Message of one alarm.
Alarm toMessage(const monitor::Alarm& alarm, bool is_first_out, const TimeOrigin& time);
/// Message of all alarms; the header is left to the caller.
AlarmArray toMessage(const monitor::AlarmSet& alarms, const TimeOrigin& time);
/// Message of one entry of the log; value, peak and place are those of then.
AlarmEvent toMessage(const monitor::AlarmEvent& event, const monitor::AlarmSet& alarms, const TimeOrigin& time);

/// **Publishes** (private) alarms (latched, on change and once a second) and events (every change once).
class AlarmPublisher
{
 public:
  explicit AlarmPublisher(ros::NodeHandle& private_nh);

  /// After a cycle or an operator's action.
  void publish(const std_msgs::Header& header, const monitor::AlarmSet& alarms, const TimeOrigin& time);
  /// What is in the log was published by the node that wrote it.
  void skip(const monitor::AlarmSet& alarms) { last_event_ = alarms.log().last(); }

 private:
  ros::Publisher alarms_, events_;
  ros::Time last_;
  long last_event_ = 0;
};

}  // namespace tether_monitor
