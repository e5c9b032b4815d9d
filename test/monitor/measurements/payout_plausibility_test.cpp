#include "tether_monitor/monitor/measurements/payout_plausibility.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
using Verdict = PayoutPlausibility::Verdict;

// Reports at 10 Hz for ten seconds.
template <typename Length, typename Rate>
PayoutPlausibility after(const Length& length, const Rate& rate)
{
  PayoutPlausibility winch;
  for (int i = 0; i <= 100; ++i)
    EXPECT_EQ(winch.check(0.1 * i, length(0.1 * i), rate(0.1 * i)), Verdict::GOOD);
  return winch;
}
}  // namespace

TEST(PayoutPlausibility, AWinchThatPaysOutIsGood)
{
  const PayoutPlausibility winch =
      after([](double t) { return 100.0 + 1.2 * t; }, [](double t) { return t < 5.0 ? 1.2 : 1.15; });
  EXPECT_TRUE(winch.trustsRate());
  EXPECT_TRUE(after([](double t) { return 100.0 + t; }, [](double) { return NAN; }).trustsRate());
}

TEST(PayoutPlausibility, AFrozenCounterAndAWrongRateAreTold)
{
  const PayoutPlausibility frozen = after([](double) { return 100.0; }, [](double) { return 1.0; });
  EXPECT_FALSE(frozen.trustsRate());
  EXPECT_GT(frozen.lastFrozen(), 9.0);
  for (const double wrong : {-1.0, 0.0})
  {
    const PayoutPlausibility winch = after([](double t) { return 100.0 + t; }, [&](double) { return wrong; });
    EXPECT_FALSE(winch.trustsRate());
    EXPECT_GT(winch.lastContradiction(), 9.0);
    EXPECT_LT(winch.lastFrozen(), 0.0);
  }
}

TEST(PayoutPlausibility, ALeapIsBelievedWhenItLasts)
{
  PayoutPlausibility winch = after([](double) { return 100.0; }, [](double) { return 0.0; });
  EXPECT_EQ(winch.check(10.1, 120.0, 0.0), Verdict::DOUBTFUL);
  EXPECT_EQ(winch.check(10.2, 100.0, 0.0), Verdict::GOOD);
  for (int i = 0; i < 3; ++i)
    EXPECT_EQ(winch.check(10.3 + 0.1 * i, 120.0, 0.0), Verdict::DOUBTFUL);
  EXPECT_EQ(winch.check(10.6, 120.0, 0.0), Verdict::REACQUIRED);
  EXPECT_EQ(winch.lastOther(), 10.6);
}

}  // namespace tether_monitor::monitor
