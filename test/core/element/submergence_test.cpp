#include "tether_monitor/core/element/submergence.h"

#include <gtest/gtest.h>

namespace tether_monitor::core
{
TEST(Submergence, IsOneBelowNothingAboveAndAHalfAtTheSurface)
{
  EXPECT_EQ(submergence(-0.5, 1.0).fraction, 1.0);
  EXPECT_EQ(submergence(-100.0, 1.0).fraction, 1.0);
  EXPECT_EQ(submergence(0.5, 1.0).fraction, 0.0);
  EXPECT_EQ(submergence(100.0, 1.0).fraction, 0.0);
  EXPECT_EQ(submergence(0.0, 1.0).fraction, 0.5);
  // x = 1/2: 1/2 - 3/8 + 1/32.
  EXPECT_NEAR(submergence(0.5, 2.0).fraction, 0.15625, 1e-15);
  EXPECT_NEAR(submergence(-0.5, 2.0).fraction, 0.84375, 1e-15);
}

TEST(Submergence, HasNeitherJumpNorKinkAtItsEnds)
{
  const double extent = 3.0, h = 1e-6;
  for (const double end : {-1.5, 1.5})
  {
    EXPECT_NEAR(submergence(end - h, extent).fraction, submergence(end + h, extent).fraction, 1e-11);
    EXPECT_NEAR(submergence(end - h, extent).slope, 0.0, 2e-6);
    EXPECT_NEAR(submergence(end + h, extent).slope, 0.0, 2e-6);
  }
}

TEST(Submergence, SlopeIsTheDerivative)
{
  const double h = 1e-6;
  for (const double extent : {0.2, 4.0})
    for (double x = -0.75; x < 0.8; x += 0.1)
    {
      const double z = x * extent;
      const double fall = submergence(z - h, extent).fraction - submergence(z + h, extent).fraction;
      EXPECT_NEAR(submergence(z, extent).slope, fall / (2.0 * h), 1e-6) << "z " << z << ", extent " << extent;
    }
  EXPECT_DOUBLE_EQ(submergence(0.0, 4.0).slope, 0.375) << "3 / (2 extent)";
}
}  // namespace tether_monitor::core
