#pragma once

#include <string>

#include "tether_monitor/monitor/alarms/alarm.h"

namespace tether_monitor
{
/// Where an alarm stands in its life, for a person: "ACTIVE", "back in limits, not acknowledged".
const char* alarmStateText(monitor::AlarmState state);

/// One line for a person: "over_tension: 1.12 is above 1 (fraction of the working load) at s = 0 m".
std::string alarmText(const monitor::Alarm& alarm);

}  // namespace tether_monitor
