#include "tether_monitor/ros/cycle_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor
{
TEST(LatencyStatistics, HasQuantilesOfTheLastSamplesAndTheLargestOfAll)
{
  LatencyStatistics latency;
  EXPECT_TRUE(std::isnan(latency.quantile(0.5)));
  latency.add(99.0);
  for (int k = 1; k <= static_cast<int>(LatencyStatistics::CAPACITY); ++k)
    latency.add(k);
  EXPECT_EQ(latency.count(), LatencyStatistics::CAPACITY);
  EXPECT_NEAR(latency.quantile(0.5), 1000.0, 1.0);
  EXPECT_NEAR(latency.quantile(0.99), 1980.0, 1.0);
  EXPECT_DOUBLE_EQ(latency.most(), 2000.0);
}

TEST(CycleStatistics, CountsWhatIsMissedAndWhatIsLate)
{
  CycleStatistics cycles(0.1);  // a hundred in ten seconds
  EXPECT_DOUBLE_EQ(cycles.lateShare(), 0.0);
  for (int k = 0; k < 90; ++k)
    cycles.add(0.01);
  EXPECT_DOUBLE_EQ(cycles.lateShare(), 0.0);
  cycles.add(0.06);  // late
  cycles.add(0.35);  // late, and three were missed
  EXPECT_EQ(cycles.cycles(), 92);
  EXPECT_EQ(cycles.missed(), 3);
  EXPECT_NEAR(cycles.lateShare(), 5.0 / 95.0, 1e-12);
  for (int k = 0; k < 100; ++k)
    cycles.add(0.0);
  EXPECT_DOUBLE_EQ(cycles.lateShare(), 0.0) << "it was more than ten seconds ago";
  EXPECT_EQ(cycles.missed(), 3);
}

TEST(CycleStatistics, AnEndlessGapIsCountedWithinBounds)
{
  CycleStatistics cycles(0.05);
  cycles.add(1e9);
  EXPECT_EQ(cycles.missed(), 100000);
  EXPECT_DOUBLE_EQ(cycles.lateShare(), 1.0);
}

}  // namespace tether_monitor
