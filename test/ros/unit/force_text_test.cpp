#include "tether_monitor/ros/force_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor
{
TEST(ForceText, HasThreeFiguresAndTheUnitThatFits)
{
  EXPECT_EQ(forceText(4536.0), "4.54 kN");
  EXPECT_EQ(forceText(82.3), "82.3 N");
  EXPECT_EQ(forceText(0.469), "0.469 N");
  EXPECT_EQ(forceText(999.4), "999 N");
  EXPECT_EQ(forceText(999.6), "1 kN");
  EXPECT_EQ(forceText(-12345.0), "-12.3 kN");
  EXPECT_EQ(forceText(2.5e6), "2.5 MN");
  EXPECT_EQ(forceText(0.0), "0 N");
  EXPECT_EQ(forceText(std::nan("")), "unknown");
}
}  // namespace tether_monitor
