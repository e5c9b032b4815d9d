#include "tether_monitor/monitor/alarms/alarm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
Alarm over(bool latch)
{
  return Alarm({"over", Severity::ALARM, Side::ABOVE, 1.0, {0.2, 1.0, 0.1, latch}});
}

TEST(AlarmLife, ComesAfterTheOnDelayOnly)
{
  Alarm alarm = over(true);
  alarm.update(0.0, 1.5, 3.0);
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
  alarm.update(0.1, 0.9, 3.0);  // back: the delay starts again
  alarm.update(0.15, 1.5, 3.0);
  alarm.update(0.3, 1.5, 3.0);
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
  EXPECT_TRUE(alarm.update(0.35, 1.5, 3.0));
  EXPECT_EQ(alarm.state(), AlarmState::UNACKNOWLEDGED);
  EXPECT_DOUBLE_EQ(alarm.since(), 0.35);
  EXPECT_DOUBLE_EQ(alarm.s(), 3.0);
}

TEST(AlarmLife, AValueAtTheLimitIsNotPastIt)
{
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, {}});
  EXPECT_FALSE(alarm.update(0.0, 1.0, NAN));
  EXPECT_TRUE(alarm.update(0.1, 1.0 + 1e-9, NAN));
}

TEST(AlarmLife, StaysInsideTheDeadbandAndLatchesUntilAcknowledged)
{
  Alarm alarm = over(true);
  alarm.update(0.0, 2.0, NAN);
  alarm.update(0.2, 2.0, NAN);
  ASSERT_TRUE(alarm.isActive()) << "precondition";
  for (double t = 0.3; t < 5.0; t += 0.1)
    alarm.update(t, 0.95, NAN);  // below the limit, inside the deadband
  EXPECT_EQ(alarm.state(), AlarmState::UNACKNOWLEDGED);
  alarm.update(5.0, 0.5, NAN);
  alarm.update(5.9, 0.5, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::UNACKNOWLEDGED) << "off-delay";
  alarm.update(6.0, 0.5, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::RETURNED_UNACKNOWLEDGED);
  EXPECT_TRUE(alarm.isAnnunciated());
  EXPECT_TRUE(alarm.acknowledge(7.0));
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
  EXPECT_FALSE(alarm.acknowledge(8.0));
}

TEST(AlarmLife, AReturnedAlarmThatComesBackIsActiveAgain)
{
  Alarm alarm = over(true);
  for (const auto& [t, value] : {std::pair(0.0, 2.0), {0.2, 2.0}, {1.0, 0.0}, {2.0, 0.0}})
    alarm.update(t, value, NAN);
  ASSERT_EQ(alarm.state(), AlarmState::RETURNED_UNACKNOWLEDGED);
  alarm.update(3.0, 2.0, NAN);
  alarm.update(3.2, 2.0, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::UNACKNOWLEDGED);
}

TEST(AlarmLife, AcknowledgedGoesStraightToNormal)
{
  Alarm alarm = over(true);
  alarm.update(0.0, 2.0, NAN);
  alarm.update(0.2, 2.0, NAN);
  EXPECT_TRUE(alarm.acknowledge(0.5));
  EXPECT_EQ(alarm.state(), AlarmState::ACKNOWLEDGED);
  EXPECT_TRUE(alarm.isAnnunciated());
  alarm.update(1.0, 0.0, NAN);
  alarm.update(2.0, 0.0, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
}

TEST(AlarmLife, WithoutLatchItReturnsByItself)
{
  Alarm alarm = over(false);
  for (const auto& [t, value] : {std::pair(0.0, 2.0), {0.2, 2.0}, {1.0, 0.0}, {2.0, 0.0}})
    alarm.update(t, value, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
}

TEST(AlarmLife, AnUnknownValueClearsNothing)
{
  Alarm alarm = over(false);
  alarm.update(0.0, 2.0, NAN);
  alarm.update(0.2, 2.0, NAN);
  for (double t = 0.3; t < 10.0; t += 0.1)
    alarm.update(t, NAN, NAN);
  EXPECT_TRUE(alarm.isActive());
}

TEST(AlarmLife, BelowIsTheBadSideWhereItIsSaidSo)
{
  Alarm alarm({"bend", Severity::ALARM, Side::BELOW, 0.4, {0.0, 0.0, 0.1, false}});
  EXPECT_FALSE(alarm.update(0.0, 0.5, NAN));
  EXPECT_TRUE(alarm.update(1.0, 0.3, NAN));
  EXPECT_FALSE(alarm.update(2.0, 0.45, NAN)) << "deadband";
  EXPECT_TRUE(alarm.update(3.0, 0.55, NAN));
}

}  // namespace tether_monitor::monitor
