#include <cmath>

#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

TEST(OverTension, HysteresisLatchAndAcknowledge)
{
  RosTestBench scenario;
  scenario.run(2.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  ASSERT_FALSE(scenario.over_tension);
  ASSERT_TRUE(scenario.alarm("over_tension"));
  EXPECT_EQ(scenario.alarm("over_tension")->state, Alarm::NORMAL);

  // The vehicle drives away until the tether is taut.
  scenario.vehicle_velocity = {0.8, 0.0, -0.5};
  double past_limit_since = NAN;
  for (int i = 0; i < 400 && !scenario.over_tension; ++i)
  {
    scenario.run(0.05);
    if (!(scenario.state.working_utilisation > 1.0))
      past_limit_since = NAN;
    else if (std::isnan(past_limit_since))
      past_limit_since = scenario.time;
  }
  ASSERT_TRUE(scenario.over_tension);
  EXPECT_GE(scenario.time - past_limit_since, 0.2 - 1e-6) << "on_delay";
  EXPECT_LE(scenario.time - past_limit_since, 0.3 + 1e-6);
  ASSERT_TRUE(
      scenario.waitFor([&] { return scenario.alarm("over_tension")->state == Alarm::UNACKNOWLEDGED; }, 10.0));
  EXPECT_EQ(scenario.alarm("over_tension")->severity, Alarm::ALARM);
  EXPECT_GT(scenario.alarm("over_tension")->value, 1.0);
  EXPECT_EQ(scenario.alarm("over_tension")->limit, 1.0);
  EXPECT_EQ(scenario.alarm("over_tension_warning")->state, Alarm::UNACKNOWLEDGED);
  EXPECT_NEAR(scenario.alarm("over_tension")->since.toSec(), scenario.time, 0.06);

  // Back again: latched until it is acknowledged.
  scenario.vehicle_velocity = {-0.8, 0.0, 0.5};
  scenario.run(6.0);
  ASSERT_LT(scenario.state.working_utilisation, 0.5) << "precondition";
  EXPECT_TRUE(scenario.over_tension);
  EXPECT_EQ(scenario.alarm("over_tension")->state, Alarm::RETURNED_UNACKNOWLEDGED);
  scenario.vehicle_velocity = {0.0, 0.0, 0.0};
  EXPECT_EQ(scenario.alarm("over_tension_warning")->state, Alarm::RETURNED_UNACKNOWLEDGED);
  EXPECT_NE(scenario.call("acknowledge").find(" alarm(s) acknowledged"), std::string::npos);
  scenario.run(0.2);
  EXPECT_FALSE(scenario.over_tension);
  EXPECT_EQ(scenario.alarm("over_tension")->state, Alarm::NORMAL);
  EXPECT_EQ(scenario.alarm("over_tension_warning")->state, Alarm::NORMAL);
}
