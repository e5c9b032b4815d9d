#include "tether_monitor/ros/time_conversion.h"

#include <gtest/gtest.h>

namespace tether_monitor
{
TEST(TimeOrigin, GoesBothWaysToTheNanosecond)
{
  const TimeOrigin base(ros::Time(1700000000, 123456789));
  EXPECT_NEAR(base.seconds(ros::Time(1700000001, 5)), 1.000000005, 1e-12);
  EXPECT_EQ(base.stamp(base.seconds(ros::Time(1700000123, 456789012))), ros::Time(1700000123, 456789012));
  EXPECT_EQ(TimeOrigin().stamp(-5.0), ros::Time());
}

TEST(TimeOrigin, AnyTwoTimesHaveADistance)
{
  const ros::Time last(4294967295u, 999999999), recent(1700000000, 0);
  EXPECT_NEAR(secondsBetween(last, recent), 2594967296.0, 1e-3);
  EXPECT_NEAR(secondsBetween(recent, last), -2594967296.0, 1e-3);
  EXPECT_EQ(secondsBetween(recent, ros::Time()), 1700000000.0);
  const TimeOrigin base(ros::Time(2524608000u, 0));  // 2050
  EXPECT_EQ(base.stamp(base.seconds(ros::Time(2524608100u, 250000000))), ros::Time(2524608100u, 250000000));
  EXPECT_EQ(base.epoch(), 2524608000.0);
  EXPECT_EQ(base.stamp(1e300), last);
  EXPECT_EQ(base.stamp(-1e300), ros::Time());
  EXPECT_EQ(base.stamp(NAN), ros::Time());
}

}  // namespace tether_monitor
