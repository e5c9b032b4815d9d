#include "tether_monitor/monitor/alarms/alarm_table.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace tether_monitor::monitor
{
const char* const BEGIN = "<!-- table of alarms: begin -->\n";
const char* const END = "<!-- table of alarms: end -->";

// With the environment variable TETHER_MONITOR_WRITE_TABLES set it writes the table instead.
TEST(AlarmTable, IsTheOneOfTheDocuments)
{
  const std::string path = std::string(PROJECT_DIR) + "/doc/alarms.md";
  std::stringstream text;
  text << std::ifstream(path).rdbuf();
  std::string document = text.str();
  const std::size_t begin = document.find(BEGIN), end = document.find(END);
  ASSERT_NE(begin, std::string::npos);
  ASSERT_NE(end, std::string::npos);
  const std::size_t first = begin + std::string(BEGIN).size();
  if (std::getenv("TETHER_MONITOR_WRITE_TABLES"))
    std::ofstream(path) << document.replace(first, end - first, alarmTable());
  EXPECT_EQ(document.substr(first, document.find(END) - first), alarmTable())
      << "write it anew: TETHER_MONITOR_WRITE_TABLES=1 scripts/test -R alarm_table";
}

}  // namespace tether_monitor::monitor
