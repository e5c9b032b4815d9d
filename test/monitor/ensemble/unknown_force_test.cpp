#include "tether_monitor/monitor/ensemble/unknown_force.h"

#include <gtest/gtest.h>

namespace tether_monitor::monitor
{
// (E24) with 100 N told.
TEST(UnknownForce, IsThoughtLargerWhereItIsFoundToBe)
{
  UnknownForce told;
  told.slow_stddev = 100.0;
  told.fast_stddev = 40.0;
  EXPECT_EQ(reconsidered(told, told, 190.0).slow_stddev, 100.0) << "two standard deviations are nothing special";
  EXPECT_EQ(reconsidered(told, told, 230.0).slow_stddev, 100.0) << "a step would be less than a fifth";
  const UnknownForce larger = reconsidered(told, told, 600.0);
  EXPECT_DOUBLE_EQ(larger.slow_stddev, 300.0);
  EXPECT_DOUBLE_EQ(larger.fast_stddev, 120.0);
  EXPECT_EQ(larger.slow_memory, told.slow_memory);
  EXPECT_EQ(reconsidered(told, larger, 620.0).slow_stddev, 300.0) << "noise moves nothing";
  EXPECT_DOUBLE_EQ(reconsidered(told, larger, 400.0).slow_stddev, 200.0) << "it may become smaller";
  EXPECT_DOUBLE_EQ(reconsidered(told, larger, 150.0).slow_stddev, 100.0) << "but not than told";
  EXPECT_DOUBLE_EQ(reconsidered(told, told, 1e6).slow_stddev, 800.0);
}
}  // namespace tether_monitor::monitor
