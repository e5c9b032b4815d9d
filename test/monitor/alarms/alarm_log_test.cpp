#include "tether_monitor/monitor/alarms/alarm_log.h"

#include <gtest/gtest.h>

namespace tether_monitor::monitor
{
TEST(AlarmLog, KeepsTheLastOnesAndNumbersAll)
{
  AlarmLog log;
  EXPECT_EQ(log.last(), 0);
  for (int k = 0; k < static_cast<int>(AlarmLog::CAPACITY) + 7; ++k)
  {
    AlarmEvent event;
    event.t = k;
    event.alarm = k % 3;
    log.note(event);
  }
  EXPECT_EQ(log.last(), static_cast<long>(AlarmLog::CAPACITY) + 7);
  ASSERT_EQ(log.events().size(), AlarmLog::CAPACITY);
  EXPECT_EQ(log.events().front().number, 8);
  EXPECT_EQ(log.events().back().number, log.last());
  EXPECT_TRUE(log.isValid(3));
  EXPECT_FALSE(log.isValid(2)) << "of an alarm that there is not";
}

}  // namespace tether_monitor::monitor
