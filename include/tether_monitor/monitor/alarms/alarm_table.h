#pragma once

#include <string>

namespace tether_monitor::monitor
{
/// The table of alarms of doc/alarms.md: a row for each of alarmQuantities(), in Markdown.
std::string alarmTable();

}  // namespace tether_monitor::monitor
