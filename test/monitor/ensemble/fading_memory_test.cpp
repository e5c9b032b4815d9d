#include "tether_monitor/monitor/ensemble/fading_memory.h"

#include <gtest/gtest.h>

namespace tether_monitor::monitor
{
TEST(FadingMemory, BeginsAnewAfterAGapAndBackInTime)
{
  FadingMemory memory;
  EXPECT_TRUE(memory.isEmpty());
  EXPECT_TRUE(memory.isContinuedAt(-1e6));
  EXPECT_EQ(memory.advance(100.0), 0.0);
  EXPECT_FALSE(memory.isEmpty());
  EXPECT_FALSE(memory.isContinuedAt(100.0));
  EXPECT_FALSE(memory.isContinuedAt(99.0));
  EXPECT_TRUE(memory.isContinuedAt(160.0));
  EXPECT_FALSE(memory.isContinuedAt(160.1));
}

TEST(FadingMemory, IsReadyAfterTenSeconds)
{
  FadingMemory memory;
  memory.advance(0.0);
  memory.advance(9.9);
  EXPECT_FALSE(memory.isReady());
  EXPECT_DOUBLE_EQ(memory.advance(10.5), 10.5 - 9.9);
  EXPECT_TRUE(memory.isReady());
}

// The first counts for all, then it is a mean of what has been, then one of the memory's length.
TEST(FadingMemory, MeanOfARampLagsByTheMemory)
{
  constexpr double DT = 0.01, MEMORY = 20.0;
  FadingMemory memory;
  EXPECT_EQ(memory.shareOfNow(memory.advance(0.0), MEMORY), 1.0);
  double mean = 0.0;
  for (double t = DT; t < 200.0; t += DT)
    mean += memory.shareOfNow(memory.advance(t), MEMORY) * (t - mean);
  EXPECT_NEAR(mean, 200.0 - MEMORY, 0.05);
  EXPECT_NEAR(memory.independent(MEMORY, 5.0), 8.0, 1e-9);
}
}  // namespace tether_monitor::monitor
