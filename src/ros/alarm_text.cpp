#include "tether_monitor/ros/alarm_text.h"

#include <cmath>
#include <cstdio>
#include <ctime>

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

std::string alarmText(const monitor::Alarm& alarm, const TimeOrigin& time)
{
  const monitor::AlarmDefinition& d = alarm.definition();
  const char* side = d.side == monitor::Side::ABOVE ? "above" : "below";
  char piece[200];
  std::snprintf(piece, sizeof(piece), "%s %s: %.3g %s, limit %s %.3g", d.name.c_str(),
                alarmStateText(alarm.state()), alarm.value(), d.unit.c_str(), side, d.limit);
  std::string text = piece;
  if (!std::isnan(alarm.onset()))
  {
    const std::time_t onset = time.stamp(alarm.onset()).sec;
    std::tm utc{};
    gmtime_r(&onset, &utc);
    std::snprintf(piece, sizeof(piece), ", peak %.3g, since %02d:%02d:%02d UTC", alarm.peak(), utc.tm_hour,
                  utc.tm_min, utc.tm_sec);
    text += piece;
  }
  if (!std::isnan(alarm.s()))
  {
    std::snprintf(piece, sizeof(piece), ", at s = %.1f m", alarm.s());
    text += piece;
  }
  return text;
}

}  // namespace tether_monitor
