#include <cmath>

#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

TEST(StaleVehicle, MonitorGoesInvalidAndSaysWhy)
{
  RosTestBench scenario;
  scenario.run(2.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  ASSERT_FALSE(scenario.over_tension);

  scenario.vehicle_alive = false;
  scenario.run(1.5);  // pose_timeout is 1 s
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_DEGRADED);
  EXPECT_EQ(scenario.state.reason, TetherState::REASON_VEHICLE_STALE);
  EXPECT_FALSE(scenario.state.s.empty());

  const int before = scenario.over_tension_count;
  scenario.run(2.0);  // invalid_timeout is 3 s
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_INVALID);
  EXPECT_EQ(scenario.state.reason, TetherState::REASON_VEHICLE_STALE);
  EXPECT_TRUE(std::isnan(scenario.state.max_tension)) << "an invalid state must not carry a usable number";
  EXPECT_TRUE(std::isnan(scenario.state.vessel_tension));
  EXPECT_TRUE(scenario.state.s.empty());
  EXPECT_TRUE(scenario.state.position.empty());
  EXPECT_TRUE(scenario.over_tension);
  EXPECT_GE(scenario.over_tension_count, before + 38) << "the word comes every cycle";
  EXPECT_NEAR(scenario.state.vehicle_age, 3.5, 0.06);
  EXPECT_NEAR(scenario.state.header.stamp.toSec(), scenario.time, 1e-3);
  EXPECT_TRUE(scenario.diagnosticsSay("VEHICLE_STALE"));
  EXPECT_TRUE(scenario.diagnosticsSay("acoustic positioning"));
  EXPECT_EQ(scenario.alarm("stale_input")->state, Alarm::UNACKNOWLEDGED);

  scenario.vehicle_alive = true;
  scenario.run(1.0);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_OK) << "it recovers";
}
