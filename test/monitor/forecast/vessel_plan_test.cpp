#include "tether_monitor/monitor/forecast/vessel_plan.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
TEST(VesselPlan, HasAVelocityWithinItsTimesOnly)
{
  VesselPlan plan;
  EXPECT_FALSE(plan.velocity(0.0));
  ASSERT_EQ(plan.set({{10.0, {0.0, 0.0, 0.0}}, {20.0, {10.0, 0.0, 5.0}}, {40.0, {10.0, 40.0, 0.0}}}), "");
  EXPECT_FALSE(plan.velocity(9.9));
  EXPECT_EQ(*plan.velocity(10.0), core::Vector3(1.0, 0.0, 0.0)) << "a vessel does not climb";
  EXPECT_EQ(*plan.velocity(19.9), core::Vector3(1.0, 0.0, 0.0));
  EXPECT_EQ(*plan.velocity(20.1), core::Vector3(0.0, 2.0, 0.0));
  EXPECT_EQ(*plan.velocity(40.0), core::Vector3(0.0, 2.0, 0.0));
  EXPECT_FALSE(plan.velocity(40.1));
}

TEST(VesselPlan, OneThatCannotBeIsRefusedAndTheOldOneStays)
{
  VesselPlan plan;
  plan.set({{0.0, {0.0, 0.0, 0.0}}, {10.0, {10.0, 0.0, 0.0}}});
  EXPECT_NE(plan.set({{0.0, {0.0, 0.0, 0.0}}}), "");
  EXPECT_NE(plan.set({{0.0, {0.0, 0.0, 0.0}}, {0.0, {1.0, 0.0, 0.0}}}), "");
  EXPECT_NE(plan.set({{0.0, {0.0, 0.0, 0.0}}, {1.0, {51.0, 0.0, 0.0}}}), "");
  EXPECT_NE(plan.set({{0.0, {0.0, 0.0, 0.0}}, {1.0, {NAN, 0.0, 0.0}}}), "");
  EXPECT_NE(plan.set(std::vector<VesselPlan::Point>(VesselPlan::MOST_POINTS + 1)), "");
  EXPECT_TRUE(plan.velocity(5.0));
  EXPECT_EQ(plan.set({}), "");
  EXPECT_TRUE(plan.isEmpty());
}

TEST(PayoutPlan, GoesToItsLengthAndStops)
{
  const PayoutPlan plan{10.0, 100.0, 0.5};
  EXPECT_DOUBLE_EQ(plan.rateAt(9.0, 80.0, -0.2), -0.2);
  EXPECT_DOUBLE_EQ(plan.rateAt(10.0, 80.0, -0.2), 0.5);
  EXPECT_DOUBLE_EQ(plan.rateAt(10.0, 120.0, 0.0), -0.5);
  EXPECT_DOUBLE_EQ(plan.rateAt(30.0, 99.5, 0.0), 0.25);
  EXPECT_DOUBLE_EQ(plan.rateAt(30.0, 100.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ((PayoutPlan{10.0, NAN, -0.5}).rateAt(30.0, 50.0, 0.0), -0.5) << "no length: on and on";
}

}  // namespace tether_monitor::monitor
