#include <geometry_msgs/PoseWithCovarianceStamped.h>
#include <geometry_msgs/Wrench.h>
#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Path.h>
#include <tether_monitor/WrenchWithCovarianceStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>

#include "common/last_message.h"
#include "common/main.h"
#include "common/ros_test_bench.h"

using namespace tether_monitor;

namespace
{
double sizeOf(const geometry_msgs::Vector3& v)
{
  return std::hypot(v.x, v.y, v.z);
}
}  // namespace

TEST(Bridge, ASimulatorIsGivenTheForcesAndZerosWithoutAnEstimate)
{
  LastMessage<geometry_msgs::Wrench> vessel("/sim/vessel/force"), vehicle("/sim/vehicle/force"),
      body("/sim/vehicle/body_force");
  LastMessage<geometry_msgs::WrenchStamped> end("/rov1/tether_monitor/vehicle_end/force");
  LastMessage<WrenchWithCovarianceStamped> own("/rov1/tether_monitor/vehicle_end/wrench_body");
  RosTestBench scenario;
  scenario.run(2.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  ASSERT_TRUE(scenario.waitFor([&] { return own.count > 10 && body.count > 10; }, 10.0));
  EXPECT_NEAR(sizeOf(vessel.value.force), scenario.state.vessel_tension, 1e-6 * scenario.state.vessel_tension);
  EXPECT_NEAR(vehicle.value.force.x, end.value.wrench.force.x, 1e-9);
  EXPECT_NEAR(vehicle.value.force.z, end.value.wrench.force.z, 1e-9);
  EXPECT_NEAR(body.value.force.z, end.value.wrench.force.z, 1e-9) << "the vehicle is level";
  EXPECT_NEAR(own.value.wrench.force.z, end.value.wrench.force.z, 1e-9);
  EXPECT_EQ(own.value.header.frame_id, "base_link");
  EXPECT_EQ(own.value.covariance[0], -1.0) << "not known in mode tracked";

  scenario.vessel_alive = scenario.vehicle_alive = false;
  scenario.run(8.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_INVALID) << "precondition";
  ASSERT_TRUE(scenario.waitFor([&] { return sizeOf(vehicle.value.force) == 0.0; }, 10.0));
  EXPECT_EQ(sizeOf(vessel.value.force), 0.0);
  EXPECT_EQ(sizeOf(body.value.force), 0.0);
  EXPECT_TRUE(std::isnan(own.value.wrench.force.x));
}

TEST(Bridge, TheTetherComesInStandardMessagesToo)
{
  LastMessage<nav_msgs::Path> path("/rov1/tether_monitor/path");
  LastMessage<geometry_msgs::PoseWithCovarianceStamped> vessel("/rov1/tether_monitor/vessel/estimate");
  LastMessage<tf2_msgs::TFMessage> frames("/tf");
  RosTestBench scenario;
  scenario.run(2.0);
  ASSERT_EQ(scenario.state.status, TetherState::STATUS_OK) << "precondition";
  ASSERT_TRUE(scenario.waitFor([&] { return path.count > 10 && vessel.count > 10 && frames.count > 10; }, 10.0));
  const std::vector<geometry_msgs::Point>& shape = scenario.state.position;
  ASSERT_EQ(path.value.poses.size(), shape.size());
  EXPECT_EQ(path.value.header.frame_id, "map");
  EXPECT_NEAR(path.value.poses.back().pose.position.z, shape.back().z, 0.1);
  EXPECT_EQ(vessel.value.header.frame_id, "map");
  EXPECT_NEAR(vessel.value.pose.pose.position.z, shape.front().z, 1.0) << "its reference point, not the end";
  ASSERT_EQ(frames.value.transforms.size(), 2u);
  EXPECT_EQ(frames.value.transforms[0].child_frame_id, "rov1/tether_monitor/vessel_end");
  EXPECT_EQ(frames.value.transforms[1].child_frame_id, "rov1/tether_monitor/vehicle_end");
  EXPECT_NEAR(frames.value.transforms[1].transform.translation.x, shape.back().x, 0.1);
}
