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

}  // namespace tether_monitor
