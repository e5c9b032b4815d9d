#include "tether_monitor/ros/alarm_text.h"

#include <cmath>
#include <cstdio>

namespace tether_monitor
{
const char* alarmStateText(monitor::AlarmState state)
{
  switch (state)
  {
    case monitor::AlarmState::NORMAL:
      return "normal";
    case monitor::AlarmState::UNACKNOWLEDGED:
      return "ACTIVE";
    case monitor::AlarmState::ACKNOWLEDGED:
      return "active, acknowledged";
    case monitor::AlarmState::RETURNED_UNACKNOWLEDGED:
      return "back in limits, not acknowledged";
  }
  return "unknown";
}

std::string alarmText(const monitor::Alarm& alarm)
{
  const monitor::AlarmDefinition& d = alarm.definition();
  const char* side = d.side == monitor::Side::ABOVE ? "above" : "below";
  char text[200];
  const int used = std::snprintf(text, sizeof(text), "%s %s: %.3g, limit %s %.3g", d.name.c_str(),
                                 alarmStateText(alarm.state()), alarm.value(), side, d.limit);
  if (!std::isnan(alarm.s()))
    std::snprintf(text + used, sizeof(text) - used, ", at s = %.1f m", alarm.s());
  return text;
}

}  // namespace tether_monitor
