#pragma once

#include <string>

#include "tether_monitor/monitor/alarms/alarm.h"
#include "tether_monitor/monitor/alarms/alarm_log.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// One line for a person: "over_tension ACTIVE: 1.12 fraction of working_load, limit above 1, peak 1.31, since
/// 14:03:07 UTC, at s = 0.0 m". Peak and onset stay after the return.
std::string alarmText(const monitor::Alarm& alarm, const TimeOrigin& time);

/// The same of an entry of the log: "breaking normal: 0.31 fraction of breaking_load, limit 0.9, peak 0.97, after
/// 12.4 s".
std::string eventText(const monitor::AlarmEvent& event, const monitor::AlarmDefinition& definition);

}  // namespace tether_monitor
