#include "tether_monitor/core/cable/payout_trajectory.h"

#include <gtest/gtest.h>

namespace tether_monitor::core
{
TEST(PayoutTrajectory, MeetsItsEndsAndItsRates)
{
  const PayoutTrajectory path = PayoutTrajectory::between(1.0, {10.0, 0.5, 0.0}, 3.0, {12.0, 1.5, 0.0});
  EXPECT_NEAR(path.at(1.0).length, 10.0, 1e-12);
  EXPECT_NEAR(path.at(1.0).rate, 0.5, 1e-12);
  EXPECT_NEAR(path.at(3.0).length, 12.0, 1e-12);
  EXPECT_NEAR(path.at(3.0).rate, 1.5, 1e-12);
  EXPECT_FALSE(path.isConstant());
  EXPECT_TRUE(PayoutTrajectory::constant(5.0).isConstant());
}

}  // namespace tether_monitor::core
