#include "tether_monitor/simulation/vehicle_autopilot.h"

#include <gtest/gtest.h>

#include "support/estimator_fixture.h"
#include "support/matrix_compare.h"

namespace tether_monitor::simulation
{
namespace
{
VehiclePlan plan()
{
  VehiclePlan p;
  p.body = monitor::smallVehicle();
  p.control = VehicleControl::STATION_KEEPING;
  p.start = {10.0, 0.0, -50.0};
  p.largest_thrust = 400.0;
  return p;
}

monitor::BodyState at(const core::Vector3& position)
{
  monitor::BodyState body;
  body.position = position;
  return body;
}
}  // namespace

TEST(VehicleAutopilot, AtRestOnItsPointItThrustsTheBalance)
{
  const core::Vector3 balance(100.0, -20.0, 60.0);
  VehicleAutopilot pilot(plan(), balance);
  for (int i = 0; i < 100; ++i)
  {
    const core::Wrench thrust = pilot.steer(at(plan().start), 0.1);
    EXPECT_TRUE(matricesNear(thrust.force, balance, 1e-9));
    EXPECT_TRUE(matricesNear(thrust.torque, core::Vector3::Zero(), 1e-12));
  }
  EXPECT_EQ(pilot.target(), plan().start);
}

TEST(VehicleAutopilot, PushesBackInBodyAxesAndNoHarderThanItCan)
{
  VehicleAutopilot pilot(plan(), core::Vector3::Zero());
  monitor::BodyState body = at(plan().start - core::Vector3(0.1, 0.0, 0.0));
  body.orientation = Eigen::AngleAxisd(M_PI / 2.0, core::Vector3::UnitZ());
  const core::Wrench thrust = pilot.steer(body, 0.01);
  EXPECT_LT(thrust.force.y(), -5.0) << "east is to the right of a vehicle that looks north";
  EXPECT_NEAR(thrust.force.x(), 0.0, 1e-9);
  EXPECT_LT(thrust.torque.z(), 0.0) << "back to its heading";
  VehicleAutopilot far(plan(), core::Vector3::Zero());
  EXPECT_NEAR(far.steer(at({500.0, 0.0, -50.0}), 0.01).force.norm(), 400.0, 1e-9);
}

TEST(VehicleAutopilot, TheTargetGoesToTheWaypointAndStaysThere)
{
  VehiclePlan p = plan();
  p.waypoints = {{{13.0, 4.0, -50.0}, 0.5}};
  VehicleAutopilot pilot(p, core::Vector3::Zero());
  core::Vector3 last = pilot.target();
  for (int i = 0; i < 600; ++i)
  {
    pilot.steer(at(pilot.target()), 0.1);
    EXPECT_LE((pilot.target() - last).norm(), 0.05 + 1e-12) << "no faster than told";
    last = pilot.target();
  }
  EXPECT_LT((pilot.target() - p.waypoints[0].position).norm(), p.acceptance + 0.1);
  pilot.steer(at(pilot.target()), 0.1);
  EXPECT_NEAR((pilot.target() - last).norm(), 0.0, 1e-6);
}

TEST(VehicleAutopilot, TheTargetWaitsForAVehicleThatCannotFollow)
{
  VehiclePlan p = plan();
  p.waypoints = {{{110.0, 0.0, -50.0}, 1.0}};
  VehicleAutopilot pilot(p, core::Vector3::Zero());
  for (int i = 0; i < 2000; ++i)
    pilot.steer(at(p.start), 0.1);
  EXPECT_GT((pilot.target() - p.start).norm(), 1.0);
  EXPECT_LE((pilot.target() - p.start).norm(), 3.0 + 1e-9);
}
}  // namespace tether_monitor::simulation
