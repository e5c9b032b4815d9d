#include "tether_monitor/ros/input_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor
{
TEST(InputStatistics, TellsRateAndOffsetOfTheLastWindow)
{
  InputStatistics input;
  EXPECT_FALSE(input.hasOffset());
  for (int i = 0; i <= 60; ++i)
    input.add(0.1 * i, i % 2 == 0 ? -0.02 : 0.04, "/gps");
  EXPECT_NEAR(input.rate(), 10.0, 0.3);
  ASSERT_TRUE(input.hasOffset());
  EXPECT_NEAR(input.offset().mean, 0.01, 0.001);
  EXPECT_EQ(input.offset().least, -0.02);
  EXPECT_EQ(input.offset().most, 0.04);
  EXPECT_EQ(input.count(), 61);
}

TEST(InputStatistics, KnowsWhoPublishesAndForgets)
{
  InputStatistics input;
  input.add(0.0, NAN, "/one");
  input.add(1.0, NAN, "/two");
  EXPECT_EQ(input.publishers(1.0).size(), 2u);
  EXPECT_EQ(input.publishers(5.5), std::vector<std::string>{"/two"});
  for (int i = 0; i < 1000; ++i)
    input.add(6.0, NAN, "/node" + std::to_string(i));
  EXPECT_LE(input.publishers(6.0).size(), 8u);
}

TEST(InputStatistics, OfABurstInOneInstantOfASimulatedClockTheFirstHasATime)
{
  InputStatistics input;
  EXPECT_FALSE(input.isWithoutTime(1.0, NAN));
  EXPECT_TRUE(input.isWithoutTime(1.0, NAN));
  EXPECT_TRUE(input.isWithoutTime(1.0, NAN));
  EXPECT_FALSE(input.isWithoutTime(1.05, NAN));
  EXPECT_FALSE(input.isWithoutTime(1.05, -0.02)) << "it has a stamp";
  EXPECT_EQ(input.withoutTime(), 2);
}

}  // namespace tether_monitor
