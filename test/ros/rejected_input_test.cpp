#include <cmath>

#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

TEST(RejectedInput, IsDiagnosedAndHarmsNothing)
{
  RosTestBench scenario;
  scenario.run(2.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  const double tension = scenario.state.vessel_tension;

  geometry_msgs::PoseStamped bad = scenario.pose({NAN, 0.0, -70.0}, "map");
  bad.header.stamp += ros::Duration(0.01);
  scenario.publishVehicle(bad);
  scenario.run(0.1);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_DEGRADED);
  EXPECT_EQ(scenario.state.reason, TetherState::REASON_REJECTED_INPUT);
  EXPECT_NEAR(scenario.state.vessel_tension, tension, 1e-3 * tension);
  EXPECT_TRUE(scenario.diagnosticsSay("Refused on vehicle/pose: 1, last: position is not finite"));
  scenario.run(1.5);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_OK);

  bad = scenario.pose({60.0, 0.0, -70.0}, "odom_of_somebody");
  scenario.publishVehicle(bad);
  scenario.run(0.1);
  EXPECT_EQ(scenario.state.reason, TetherState::REASON_REJECTED_INPUT);
  EXPECT_TRUE(scenario.diagnosticsSay("odom_of_somebody"));

  bad = scenario.pose({60.0, 0.0, -70.0}, "map");
  bad.pose.orientation.w = 0.5;
  bad.header.stamp += ros::Duration(0.01);
  scenario.publishVehicle(bad);
  scenario.run(0.1);
  EXPECT_TRUE(scenario.diagnosticsSay("not a unit quaternion"));

  bad = scenario.pose({60.0, 0.0, -70.0}, "map");
  bad.header.stamp = ros::Time();
  scenario.publishVehicle(bad);
  scenario.run(0.1);
  EXPECT_TRUE(scenario.diagnosticsSay("header.stamp is zero"));

  // Only the wrong frame from now on: the vehicle goes stale, it is not believed.
  scenario.frame = "odom_of_somebody";
  scenario.run(4.0);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_INVALID);
  EXPECT_TRUE(scenario.over_tension);
  scenario.frame = "map";
  scenario.run(2.0);
  EXPECT_EQ(scenario.state.status, TetherState::STATUS_OK);
}
