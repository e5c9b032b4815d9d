#include <cmath>

#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

TEST(ClockJump, BackwardsStartsAnew)
{
  RosTestBench scenario;
  scenario.run(3.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";

  scenario.time -= 500.0;  // the bag begins again
  bool said = false;
  for (int i = 0; i < 10 && !said; ++i)
  {
    scenario.run(0.05);
    said = scenario.state.reason == TetherState::REASON_CLOCK_JUMP;
    if (said)
    {
      EXPECT_EQ(scenario.state.status, TetherState::STATUS_INVALID);
      EXPECT_TRUE(std::isnan(scenario.state.max_tension));
      EXPECT_TRUE(scenario.over_tension);
    }
  }
  EXPECT_TRUE(said);
  scenario.run(2.0);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_OK);
  EXPECT_NEAR(scenario.state.header.stamp.toSec(), scenario.time, 1e-3);
  EXPECT_FALSE(scenario.over_tension);
}

TEST(ClockJump, APauseIsNoJump)
{
  RosTestBench scenario;
  scenario.time = 2000.0;
  scenario.run(3.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  ros::WallDuration(2.0).sleep();  // the clock stands still: nothing is published, nothing is lost
  scenario.run(0.05);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_OK);
}

TEST(Reset, ForgetsAndSettlesAnew)
{
  RosTestBench scenario;
  scenario.time = 3000.0;
  scenario.run(3.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  EXPECT_NE(scenario.call("reset"), "failed");
  scenario.vehicle_alive = false;
  scenario.run(0.2);
  EXPECT_EQ(scenario.state.reason, TetherState::REASON_NO_INPUT);
  scenario.vehicle_alive = true;
  scenario.run(1.0);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_OK);
}
