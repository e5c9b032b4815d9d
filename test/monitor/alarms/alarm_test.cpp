#include "tether_monitor/monitor/alarms/alarm.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
Alarm over(bool latch)
{
  return Alarm({"over", Severity::ALARM, Side::ABOVE, 1.0, {0.2, 1.0, 0.1, latch}});
}

TEST(Alarm, ComesAfterTheOnDelayOnly)
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

TEST(Alarm, AValueAtTheLimitIsNotPastIt)
{
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, {}});
  EXPECT_FALSE(alarm.update(0.0, 1.0, NAN));
  EXPECT_TRUE(alarm.update(0.1, 1.0 + 1e-9, NAN));
}

TEST(Alarm, StaysInsideTheDeadbandAndLatchesUntilAcknowledged)
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

TEST(Alarm, AReturnedAlarmThatComesBackIsActiveAgain)
{
  Alarm alarm = over(true);
  for (const auto& [t, value] : {std::pair(0.0, 2.0), {0.2, 2.0}, {1.0, 0.0}, {2.0, 0.0}})
    alarm.update(t, value, NAN);
  ASSERT_EQ(alarm.state(), AlarmState::RETURNED_UNACKNOWLEDGED);
  alarm.update(3.0, 2.0, NAN);
  alarm.update(3.2, 2.0, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::UNACKNOWLEDGED);
}

TEST(Alarm, AcknowledgedGoesStraightToNormal)
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

TEST(Alarm, WithoutLatchItReturnsByItself)
{
  Alarm alarm = over(false);
  for (const auto& [t, value] : {std::pair(0.0, 2.0), {0.2, 2.0}, {1.0, 0.0}, {2.0, 0.0}})
    alarm.update(t, value, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
}

TEST(Alarm, AnUnknownValueClearsNothing)
{
  Alarm alarm = over(false);
  alarm.update(0.0, 2.0, NAN);
  alarm.update(0.2, 2.0, NAN);
  for (double t = 0.3; t < 10.0; t += 0.1)
    alarm.update(t, NAN, NAN);
  EXPECT_TRUE(alarm.isActive());
}

TEST(Alarm, BelowIsTheBadSideWhereItIsSaidSo)
{
  Alarm alarm({"bend", Severity::ALARM, Side::BELOW, 0.4, {0.0, 0.0, 0.1, false}});
  EXPECT_FALSE(alarm.update(0.0, 0.5, NAN));
  EXPECT_TRUE(alarm.update(1.0, 0.3, NAN));
  EXPECT_FALSE(alarm.update(2.0, 0.45, NAN)) << "deadband";
  EXPECT_TRUE(alarm.update(3.0, 0.55, NAN));
}

// Raised and returned once in `period` seconds, `times` times. @return when it was over.
double chatter(Alarm& alarm, double t, double period, int times)
{
  for (int k = 0; k < times; ++k, t += period)
  {
    alarm.update(t, 2.0, NAN);
    alarm.update(t + 0.5 * period, 0.0, NAN);
  }
  return t;
}

TEST(Alarm, OneThatChattersHoldsOn)
{
  AlarmTiming timing;
  timing.chatter_hold = 20.0;
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, timing});
  chatter(alarm, 0.0, 10.0, 2);
  EXPECT_FALSE(alarm.isChattering());
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
  alarm.update(20.0, 2.0, NAN);
  EXPECT_TRUE(alarm.isChattering());
  alarm.update(21.0, 0.0, NAN);
  alarm.update(40.9, 0.0, NAN);
  EXPECT_TRUE(alarm.isActive());
  EXPECT_TRUE(alarm.update(41.0, 0.0, NAN));
  EXPECT_FALSE(alarm.isActive());
  alarm.update(81.0, 0.0, NAN);
  EXPECT_FALSE(alarm.isChattering()) << "it has been quiet";
}

TEST(Alarm, WithoutAHoldNothingChatters)
{
  AlarmTiming timing;
  timing.chatter_hold = 0.0;
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, timing});
  chatter(alarm, 0.0, 1.0, 10);
  EXPECT_FALSE(alarm.isChattering());
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
}

TEST(Alarm, IsAnnouncedAgainWhenItLasts)
{
  AlarmTiming timing;
  timing.realarm = 60.0;
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, timing});
  alarm.update(0.0, 2.0, NAN);
  alarm.acknowledge(1.0);
  EXPECT_FALSE(alarm.update(60.9, 2.0, NAN));
  EXPECT_TRUE(alarm.update(61.0, 2.0, NAN));
  EXPECT_EQ(alarm.state(), AlarmState::UNACKNOWLEDGED);
}

TEST(Alarm, WaitsForAResetWhereItIsAskedFor)
{
  AlarmTiming timing;
  timing.manual_reset = true;
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, timing});
  alarm.update(0.0, 2.0, NAN);
  alarm.acknowledge(1.0);
  alarm.update(2.0, 0.0, NAN);
  EXPECT_EQ(alarm.state(), AlarmState::LATCHED);
  EXPECT_TRUE(alarm.isAnnunciated());
  EXPECT_FALSE(alarm.acknowledge(3.0));
  EXPECT_TRUE(alarm.act(AlarmAction::RESET, 4.0));
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
}

TEST(Alarm, IsWatchedOnTheShelfAndComesBackAsItIs)
{
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, {}});
  for (const double bad : {0.0, -1.0, static_cast<double>(NAN), Alarm::LONGEST_SHELVING + 1.0})
    EXPECT_FALSE(alarm.act(AlarmAction::SHELVE, 0.0, bad)) << bad;
  ASSERT_TRUE(alarm.act(AlarmAction::SHELVE, 0.0, 100.0));
  EXPECT_FALSE(alarm.update(1.0, 2.0, NAN)) << "nothing to announce";
  EXPECT_FALSE(alarm.isAnnunciated());
  EXPECT_TRUE(alarm.isActive());
  EXPECT_DOUBLE_EQ(alarm.shelvedUntil(), 100.0);
  EXPECT_TRUE(alarm.update(100.0, 2.0, NAN));
  EXPECT_EQ(alarm.state(), AlarmState::UNACKNOWLEDGED);
  EXPECT_TRUE(std::isnan(alarm.shelvedUntil()));
}

TEST(Alarm, AJumpOfTheClockEndsTheShelving)
{
  Alarm alarm({"x", Severity::ALARM, Side::ABOVE, 1.0, {}});
  alarm.act(AlarmAction::SHELVE, 1000.0, 100.0);
  EXPECT_TRUE(alarm.resetTimers(0.0));
  EXPECT_EQ(alarm.state(), AlarmState::NORMAL);
}

}  // namespace tether_monitor::monitor
