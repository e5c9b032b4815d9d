#include "tether_monitor/monitor/ensemble/measurement_timing.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
TEST(MeasurementTiming, LearnsTheIntervalFromTheSecondOn)
{
  MeasurementTiming timing(0.5);
  EXPECT_EQ(timing.newest(), -INFINITY);
  timing.add(10.0, NAN);
  EXPECT_EQ(timing.newest(), 10.0);
  EXPECT_EQ(timing.interval(), 0.0);
  timing.add(12.0, NAN);
  EXPECT_DOUBLE_EQ(timing.interval(), 2.0);
  timing.add(13.0, NAN);
  EXPECT_GT(timing.interval(), 1.0);
  EXPECT_LT(timing.interval(), 2.0) << "towards the newer";
  for (int t = 14; t < 100; ++t)
    timing.add(t, NAN);
  EXPECT_NEAR(timing.interval(), 1.0, 1e-6);
}

TEST(MeasurementTiming, WhatIsNotLaterCountsForNothing)
{
  MeasurementTiming timing(0.0);
  timing.add(10.0, 10.0);
  timing.add(12.0, 12.0);
  timing.add(11.0, 20.0);
  timing.add(12.0, 20.0);
  EXPECT_EQ(timing.newest(), 12.0);
  EXPECT_EQ(timing.interval(), 2.0);
  EXPECT_EQ(timing.overdueTime(4.0), 0.0) << "the latency stays, too";
}

TEST(MeasurementTiming, OverdueIsTheAgeLessLatencyAndTwoIntervals)
{
  MeasurementTiming timing(0.5);
  EXPECT_DOUBLE_EQ(timing.overdueTime(3.0), 2.5) << "nothing is known but the latency";
  timing.add(10.0, 10.5);
  timing.add(12.0, 12.5);
  EXPECT_DOUBLE_EQ(timing.overdueTime(5.0), 0.5);
  for (int t = 14; t < 200; t += 2)
    timing.add(t, t + 1.5);
  EXPECT_NEAR(timing.overdueTime(5.0), 5.0 - 1.5 - 4.0, 1e-6) << "they come later now";
  for (int t = 200; t < 400; t += 2)
    timing.add(t, t);
  EXPECT_NEAR(timing.overdueTime(5.0), 0.5, 1e-6) << "never less than what every measurement has";
  timing.clear();
  EXPECT_DOUBLE_EQ(timing.overdueTime(3.0), 2.5);
}
}  // namespace tether_monitor::monitor
