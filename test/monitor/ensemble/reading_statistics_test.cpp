#include "tether_monitor/monitor/ensemble/reading_statistics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
TEST(ReadingRate, CountsTheReadingsInAMemory)
{
  ReadingRate rate;
  EXPECT_EQ(rate.repeatsIn(10.0), 1.0) << "none has come";
  rate.note(5.0);
  rate.note(5.5);
  EXPECT_NEAR(rate.repeatsIn(10.0), 20.0, 1e-9);
  rate.note(5.2);
  EXPECT_NEAR(rate.repeatsIn(10.0), 20.0, 1e-9) << "one that comes out of order tells nothing of the rate";
  rate.note(65.5);
  EXPECT_EQ(rate.repeatsIn(10.0), 1.0) << "never less than the reading itself";
}

TEST(TensionSpread, OfASineIsItsVariance)
{
  TensionSpread spread;
  for (int i = 0; i < 6000; ++i)
    spread.add(1000.0 + 200.0 * std::sin(0.05 * i), 0.05);
  EXPECT_NEAR(spread.mean, 1000.0, 20.0);
  EXPECT_NEAR(spread.variance, 0.5 * 200.0 * 200.0, 2000.0);
}
}  // namespace tether_monitor::monitor
