#include "tether_monitor/monitor/estimator/payout_follower.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
// A winch that reports at 10 Hz beside the poses.
void run(EstimatorFixture& feeder, double duration, double& length, double& rate, double target_rate)
{
  for (int k = 0; k < static_cast<int>(std::round(duration / 0.1)); ++k)
  {
    const double next = rate + std::clamp(target_rate - rate, -0.01, 0.01);  // 0.1 m/s^2
    length += 0.05 * (rate + next);
    rate = next;
    ASSERT_TRUE(feeder.estimator.addPayout(feeder.t + 0.1, length, rate));
    feeder.run(0.1);
  }
}
}  // namespace

TEST(Payout, LivePayOutNeverLeavesOkAndEndsAtTheTensionOfTheNewLength)
{
  EstimatorFixture feeder;
  double length = 100.0, rate = 0.0;
  feeder.run(1.0);
  const double before = feeder.estimator.estimate().vessel_tension;
  double last = before, jump = 0.0;
  run(feeder, 1.0, length, rate, 0.0);
  for (int k = 0; k < 200; ++k)
  {
    run(feeder, 0.1, length, rate, k < 80 ? 0.5 : 0.0);
    const TetherEstimate& e = feeder.estimator.estimate();
    ASSERT_EQ(e.status, Status::OK) << describe(e.reason) << " at " << feeder.t;
    ASSERT_NEAR(e.length, length, 0.01);
    jump = std::max(jump, std::abs(e.vessel_tension - last));
    last = e.vessel_tension;
  }
  EXPECT_NEAR(rate, 0.0, 1e-9);
  EXPECT_GT(length, 103.0) << "precondition";
  run(feeder, 40.0, length, rate, 0.0);
  Config longer = testConfig();
  longer.tether.length = length;
  EstimatorFixture other(longer);
  other.run(1.0);
  EXPECT_NEAR(feeder.estimator.estimate().vessel_tension, other.estimator.estimate().vessel_tension,
              1e-3 * before);
  EXPECT_LT(jump, 0.1 * before);
  EXPECT_NEAR(feeder.estimator.estimate().payout_rate, 0.0, 1e-6);
}

TEST(Payout, BadReportsChangeNothing)
{
  EstimatorFixture feeder;
  feeder.run(1.0);
  EXPECT_FALSE(feeder.estimator.addPayout(feeder.t, -3.0));
  EXPECT_FALSE(feeder.estimator.addPayout(feeder.t, NAN));
  EXPECT_FALSE(feeder.estimator.addPayout(feeder.t, 100.0, INFINITY));
  EXPECT_FALSE(feeder.estimator.addPayout(feeder.t, 100.0, 200.0)) << "no winch is so fast";
  EXPECT_EQ(feeder.run(0.2).length, 100.0);
  EXPECT_TRUE(std::isnan(feeder.estimator.estimate().payout_rate)) << "nothing tells it";
}

TEST(Payout, ALeapLetsTheTetherSettleAnewAndSaysSo)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(1.0).status, Status::OK) << "precondition";
  ASSERT_TRUE(feeder.estimator.addPayout(feeder.t, 130.0, 0.0));
  feeder.run(0.05);
  EXPECT_EQ(feeder.estimator.estimate().reason, Reason::SETTLING);
  EXPECT_EQ(feeder.run(0.1).status, Status::DEGRADED) << "a steady state, not a motion";
  EXPECT_DOUBLE_EQ(feeder.estimator.estimate().length, 130.0);
  for (int k = 0; k < 20; ++k)
  {
    feeder.estimator.addPayout(feeder.t + 0.1, 130.0, 0.0);
    feeder.run(0.1);
  }
  EXPECT_EQ(feeder.estimator.estimate().status, Status::OK);
}

TEST(Payout, AReportThatIsAheadOfTheWinchIsFollowedWithoutAStop)
{
  EstimatorFixture feeder;
  feeder.run(1.0);
  ASSERT_TRUE(feeder.estimator.addPayout(feeder.t, 100.0, 0.0));
  feeder.run(0.1);
  ASSERT_TRUE(feeder.estimator.addPayout(feeder.t, 100.3, 4.0));
  for (int i = 0; i < 20; ++i)
  {
    feeder.run(0.05);
    EXPECT_EQ(feeder.estimator.estimate().status, Status::OK) << i;
    EXPECT_LE(std::abs(feeder.estimator.estimate().payout_rate), 4.5) << i;
    feeder.estimator.addPayout(feeder.t, 100.3, 0.0);
  }
  EXPECT_NEAR(feeder.estimator.estimate().length, 100.3, 0.05);
}

TEST(Payout, ASilentWinchDegradesAndInvalidates)
{
  EstimatorFixture feeder;
  feeder.run(1.0);
  ASSERT_TRUE(feeder.estimator.addPayout(feeder.t, 100.0, 0.0));
  EXPECT_EQ(feeder.run(0.9).status, Status::OK);
  EXPECT_EQ(feeder.run(0.3).reason, Reason::PAYOUT_STALE);
  EXPECT_EQ(feeder.estimator.estimate().status, Status::DEGRADED);
  EXPECT_EQ(feeder.run(4.0).status, Status::INVALID);
  EXPECT_EQ(feeder.estimator.estimate().reason, Reason::PAYOUT_STALE);
}

}  // namespace tether_monitor::monitor
