#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
// Tethers without a steady state of their own: what is slack and weighs nothing can lie anywhere.
class HardToSettle : public ::testing::TestWithParam<double>
{
};

TEST_P(HardToSettle, IsFoundByMotion)
{
  Config config = testConfig();
  config.elements = 40;
  config.tether.diameter = 0.02;
  config.tether.mass_per_length = GetParam();
  EstimatorFixture feeder(config);
  feeder.vehicle = {40.0, 0.0, -50.0};
  const TetherEstimate& e = feeder.run(2.0);
  ASSERT_NE(e.status, Status::INVALID) << describe(e.reason) << ", "
                                       << core::describe(feeder.estimator.simulation().last_solve.status);
  EXPECT_LT(e.vessel_tension, 100.0);
  EXPECT_NEAR(e.stations.stretched_length, 100.0, 1.0);
}

INSTANTIATE_TEST_SUITE_P(MassPerLength, HardToSettle, ::testing::Values(0.2, 1025.0 * M_PI * 1e-4, 0.30, 0.33));

TEST(Settling, ATetherHangsOnTheSideOfAnObstacleWhereItWouldWithoutIt)
{
  Config config = testConfig();
  EndTargets ends;
  ends.vessel = {{0.0, 0.0, 1.0}, {0.0, 0.0, 1.0}};
  ends.vehicle = {{40.0, 0.0, -50.0}, {0.0, 0.0, 1.0}};
  TetherEstimator open(config);
  const double tension = open.begin(0.0, ends).vessel_tension;
  core::Obstacle box;
  box.shape = core::ObstacleShape::BOX;
  box.size = {6.0, 6.0, 6.0};
  box.position = {-3.0, 0.3, -47.28};
  config.environment.obstacles = {box};
  TetherEstimator beside(config);
  EXPECT_NEAR(beside.begin(0.0, ends).vessel_tension, tension, 1e-6 * tension);
}

TEST(Settling, SectionsThatComeAboardAreLeftOut)
{
  Config config = testConfig();
  core::CableSection heavy;
  heavy.from = 20.0;
  heavy.to = 40.0;
  heavy.properties = config.tether;
  heavy.properties.mass_per_length = 1.2;
  config.layout.sections = {heavy};
  config.layout.attachments = {{"float", 30.0, 1.0, 0.002, 0.0}};
  EstimatorFixture feeder(config);
  feeder.vehicle = {10.0, 0.0, -15.0};
  double length = 100.0;
  int invalid = 0, rows = 0;
  for (; length > 40.0; length -= 0.2, ++rows)
  {
    feeder.estimator.addPayout(feeder.t + 0.1, length, -2.0);
    invalid += feeder.run(0.1).status == Status::INVALID;
  }
  EXPECT_LT(invalid, 8) << "of " << rows << ": a cycle or two for each piece that comes aboard";
  EXPECT_NE(feeder.estimator.estimate().status, Status::INVALID);
}

TEST(Settling, AbsurdTensionIsNoNumber)
{
  Config config = testConfig();
  EstimatorFixture feeder(config);
  feeder.vehicle = {80.0, 0.0, -75.0};
  const TetherEstimate& e = feeder.run(1.0);
  EXPECT_EQ(e.status, Status::INVALID);
  EXPECT_EQ(e.reason, Reason::OUT_OF_RANGE);
  EXPECT_TRUE(std::isnan(e.max_tension));
}

// A slack tether under a vessel that sinks at the moment: it would rise above the water if that lasted.
TEST(Settling, StartsOnTheMeanMotionAndHeaveComesOnTop)
{
  const Config config = testConfig();
  EndTargets still, heaving;
  still.vessel = {{0.0, 0.0, 0.0}, {0.4, 0.0, 0.0}};
  still.vehicle = {{40.0, 0.0, -60.0}, {0.4, 0.0, 0.0}};
  heaving = still;
  heaving.vessel.velocity.z() = -1.0;
  TetherEstimator calm(config), tossed(config);
  ASSERT_EQ(calm.begin(0.0, still).status, Status::OK);
  ASSERT_EQ(tossed.begin(0.0, heaving).status, Status::OK);
  const core::CableState &a = calm.simulation().state, &b = tossed.simulation().state;
  for (std::size_t i = 0; i < a.q.size(); ++i)
    EXPECT_EQ(a.q[i], b.q[i]) << "the same shape";
  EXPECT_EQ(b.v.front().head<3>(), core::Vector3(0.4, 0.0, -1.0));
  EXPECT_EQ(b.v.back().head<3>(), core::Vector3(0.4, 0.0, 0.0));
  for (double t = 0.05; t < 10.0; t += 0.05)
  {
    EndTargets ends = heaving;
    ends.vessel.position += core::Vector3(0.4 * t, 0.0, -std::sin(t));
    ends.vessel.velocity.z() = -std::cos(t);
    ends.vehicle.position.x() += 0.4 * t;
    ASSERT_EQ(tossed.advance(t, ends).status, Status::OK) << t << " s";
  }
}

// The clamp turns with the vessel, at the start and after it.
TEST(ClampedVesselEnd, TheTetherLeavesAsTheVesselPoints)
{
  Config config = testConfig();
  config.tether.bending_stiffness = 50.0;
  config.vessel.clamped = core::Vector3(2.0, 0.0, 0.0);
  TetherEstimator estimator(config);
  for (int k = 1; k <= 200; ++k)
  {
    const double t = 0.05 * k, yaw = M_PI / 2.0 + 0.2 * std::sin(t);
    estimator.addVessel(PoseMeasurement{t, core::Vector3(0.0, 0.0, 0.0),
                                        Eigen::Quaterniond(Eigen::AngleAxisd(yaw, core::Vector3::UnitZ()))});
    estimator.addVehicle(PoseMeasurement{t, core::Vector3(40.0, 0.0, -60.0), Eigen::Quaterniond::Identity()});
    estimator.tick(t);
    if (!estimator.isRunning())
      continue;
    const core::Vector3 along = estimator.simulation().state.q.front().tail<3>().normalized();
    EXPECT_GT(along.dot(core::Vector3(std::cos(yaw), std::sin(yaw), 0.0)), 0.9999) << t;
    EXPECT_GT(estimator.estimate().stations.ends.vessel_moment.norm(), 1.0);
  }
  EXPECT_NE(estimator.estimate().status, Status::INVALID) << describe(estimator.estimate().reason);
}

}  // namespace tether_monitor::monitor
