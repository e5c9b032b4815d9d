#include "tether_monitor/ros/alarm_text.h"

#include <cmath>
#include <cstdio>
#include <ctime>

namespace tether_monitor
{
namespace
{
// "1.05 -", or that there is none: an alarm may stay while its value is not known.
std::string valueText(double value, const std::string& unit)
{
  if (std::isnan(value))
    return "not known";
  char text[60];
  std::snprintf(text, sizeof(text), "%.3g ", value);
  return text + unit;
}
}  // namespace

std::string alarmText(const monitor::Alarm& alarm, const TimeOrigin& time)
{
  const monitor::AlarmDefinition& d = alarm.definition();
  const char* side = d.side == monitor::Side::ABOVE ? "above" : "below";
  char piece[200];
  std::snprintf(piece, sizeof(piece), "%s %s: %s, limit %s %.3g", d.name.c_str(), describe(alarm.state()),
                valueText(alarm.value(), d.unit).c_str(), side, d.limit);
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
  return alarm.isChattering() ? text + ", chattering" : text;
}

std::string eventText(const monitor::AlarmEvent& event, const monitor::AlarmDefinition& definition)
{
  char text[300];
  std::snprintf(text, sizeof(text), "%s %s: %s, limit %.3g", definition.name.c_str(), describe(event.to),
                valueText(event.value, definition.unit).c_str(), definition.limit);
  if (std::isnan(event.duration) || !(event.duration > 0.0))
    return text;
  char more[100];
  std::snprintf(more, sizeof(more), ", peak %.3g, after %.1f s", event.peak, event.duration);
  return std::string(text) + more;
}

}  // namespace tether_monitor
