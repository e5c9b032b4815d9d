#include "tether_monitor/monitor/measurements/height_record.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
TEST(HeightRecord, GoesOnOnAStraightLineAndEnds)
{
  HeightRecord heights;
  EXPECT_FALSE(heights.at(0.0, 1.0));
  EXPECT_EQ(heights.add(0.0, NAN), Rejection::NOT_FINITE);
  ASSERT_EQ(heights.add(0.0, -10.0), Rejection::NONE);
  EXPECT_NEAR(*heights.at(0.5, 1.0), -10.0, 1e-12);
  ASSERT_EQ(heights.add(0.2, -10.1), Rejection::NONE);
  EXPECT_EQ(heights.add(0.2, -10.2), Rejection::OUT_OF_ORDER);
  EXPECT_NEAR(*heights.at(0.6, 1.0), -10.3, 1e-12);
  EXPECT_FALSE(heights.at(1.3, 1.0));
  EXPECT_TRUE(heights.isValid());
  heights.clear();
  EXPECT_FALSE(heights.at(0.2, 1.0));
}

TEST(HeightRecord, HeightsThatLieFarApartMakeNoRate)
{
  HeightRecord heights;
  heights.add(0.0, -10.0);
  heights.add(5.0, -20.0);
  EXPECT_NEAR(*heights.at(5.5, 1.0), -20.0, 1e-12);
}

}  // namespace tether_monitor::monitor
