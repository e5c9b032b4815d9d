#include "tether_monitor/monitor/alarms/alarm_table.h"

#include <sstream>

#include "tether_monitor/monitor/alarms/alarm_quantities.h"

namespace tether_monitor::monitor
{
namespace
{
const char* nameOf(Severity severity)
{
  switch (severity)
  {
    case Severity::WARNING:
      return "warning";
    case Severity::ALARM:
      return "alarm";
    case Severity::CRITICAL:
      return "critical";
  }
  return "";
}

std::string defaultsOf(const AlarmQuantity& quantity)
{
  const AlarmConfig& d = quantity.defaults;
  std::ostringstream text;
  if (d.warning)
    text << "warning: " << *d.warning << ", ";
  if (d.limit)
    text << "limit: " << *d.limit << ", ";
  text << "on_delay: " << d.timing.on_delay << ", off_delay: " << d.timing.off_delay;
  if (d.timing.deadband > 0.0)
    text << ", deadband: " << d.timing.deadband;
  if (d.timing.latch)
    text << ", latch: true";
  return text.str();
}
}  // namespace

std::string alarmTable()
{
  std::ostringstream table;
  table << "| `monitor.alarms.` | watches | unit | bad | priority | defaults | what to do "
           "|\n|---|---|---|---|---|---|---|\n";
  for (const AlarmQuantity& quantity : alarmQuantities())
  {
    const bool is_off = !quantity.defaults.limit && !quantity.defaults.warning && !quantity.derivedLimit;
    table << "| `" << quantity.name << "` | " << quantity.meaning << " | " << quantity.unit << " | "
          << (quantity.side == Side::ABOVE ? "above" : "below") << " | " << nameOf(quantity.severity) << " | "
          << (is_off ? "off; " : "") << "`{" << defaultsOf(quantity) << "}` | " << quantity.advice << " |\n";
  }
  return table.str();
}

}  // namespace tether_monitor::monitor
