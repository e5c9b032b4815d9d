#pragma once

#include <string>

#include "tether_monitor/monitor/alarms/alarm.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// Where an alarm stands in its life, for a person: "ACTIVE", "back in limits, not acknowledged".
const char* alarmStateText(monitor::AlarmState state);

/// One line for a person: "over_tension ACTIVE: 1.12 fraction of working_load, limit above 1, peak 1.31, since
/// 14:03:07 UTC, at s = 0.0 m". Peak and onset stay after the return.
std::string alarmText(const monitor::Alarm& alarm, const TimeOrigin& time);

}  // namespace tether_monitor
