#include "tether_monitor/monitor/measurements/payout_buffer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
TEST(PayoutBuffer, InterpolatesExtrapolatesAndSpreadsCorrections)
{
  PayoutBuffer track;
  EXPECT_TRUE(std::isinf(track.age(0.0)));
  ASSERT_TRUE(track.add(0.0, 100.0, 1.0));
  ASSERT_TRUE(track.add(1.0, 101.0, 1.0));
  EXPECT_FALSE(track.add(1.0, 102.0, 1.0)) << "not later";
  EXPECT_NEAR(track.blend(0.5).length, 100.5, 1e-12);
  EXPECT_NEAR(track.blend(1.4).length, 101.4, 1e-12);
  EXPECT_NEAR(track.age(1.4), 0.4, 1e-12);
  // The next report is 2 cm off the extrapolation: no jump, but there within the interval.
  double before = track.blend(1.95).length;
  ASSERT_TRUE(track.add(2.0, 102.02, 1.0));
  for (double t = 2.0; t < 4.0; t += 0.05)
  {
    const double now = track.blend(t).length;
    EXPECT_NEAR(now - before, 0.05, 0.005) << t;
    before = now;
  }
  EXPECT_NEAR(track.blend(4.0).length, 104.02, 2e-3);
}

TEST(PayoutBuffer, AnUntoldRateIsTheSlope)
{
  PayoutBuffer track;
  track.add(0.0, 50.0, NAN);
  track.add(2.0, 51.0, NAN);
  EXPECT_NEAR(track.blend(3.0).length, 51.5, 1e-12);
}

}  // namespace tether_monitor::monitor
