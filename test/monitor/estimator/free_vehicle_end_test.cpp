#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
Config towedFish()
{
  Config c = testConfig();
  c.vehicle_mode = VehicleMode::FREE;
  c.vehicle.attachment = {0.4, 0.0, 0.1};
  c.vehicle_body.mass = 150.0;
  c.vehicle_body.volume = 0.1;
  c.vehicle_body.inertia = {5.0, 20.0, 20.0};
  c.vehicle_body.drag_area = {0.1, 0.4, 0.4};
  c.vehicle_body.rotational_drag = {10.0, 50.0, 50.0};
  c.vehicle_body.center_of_buoyancy = {0.0, 0.0, 0.05};
  return c;
}
}  // namespace

TEST(FreeVehicle, NeedsNoPoseOfTheVehicleAndTellsItsOwn)
{
  EstimatorFixture feeder(towedFish());
  feeder.vehicle_alive = false;
  const TetherEstimate& e = feeder.run(2.0);
  ASSERT_EQ(e.status, Status::OK) << describe(e.reason);
  ASSERT_TRUE(e.has_vehicle);
  EXPECT_NEAR(e.vehicle.position.z(), 1.0 - 100.0, 2.0) << "it hangs straight down";
  const core::Vector3 end = e.vehicle.position + e.vehicle.orientation * core::Vector3(0.4, 0.0, 0.1);
  EXPECT_LT((end - e.stations.position.back()).norm(), 1e-9);
  EXPECT_EQ(e.vehicle_age, 0.0);
}

TEST(FreeVehicle, ThrustMovesIt)
{
  EstimatorFixture feeder(towedFish());
  feeder.vehicle_alive = false;
  feeder.run(2.0);
  const double before = feeder.estimator.estimate().vehicle.position.y();
  const TetherEstimate& e = feeder.estimator.estimate();
  for (int k = 0; k < 200; ++k)
  {
    feeder.estimator.setThrust(feeder.t, {core::Vector3(0.0, 200.0, 0.0), core::Vector3::Zero()});
    feeder.run(0.1);
  }
  EXPECT_EQ(e.status, Status::OK);
  EXPECT_GT(e.vehicle.position.y() - before, 1.0);
}

TEST(FreeVehicle, UnderThrustItStartsWhereThatHoldsIt)
{
  Config config = towedFish();
  config.vehicle.attachment = core::Vector3::Zero();
  config.vehicle_body.volume = 150.0 / 1025.0;  // neutral: what pulls at the tether is the thrust
  TetherEstimator estimator(config);
  const core::Wrench thrust{core::Vector3(120.0, 40.0, -60.0), core::Vector3::Zero()};
  estimator.setThrust(0.0, thrust);
  EndTargets ends;
  ends.vessel = {core::Vector3::Zero(), core::Vector3::Zero()};
  ASSERT_EQ(estimator.begin(0.0, ends).status, Status::OK);
  const core::Vector3 place = estimator.estimate().vehicle.position;
  EXPECT_NEAR(estimator.estimate().vehicle_tension, thrust.force.norm(), 1e-3);
  EXPECT_GT(place.x(), 50.0);
  for (double t = 0.05; t < 60.0; t += 0.05)
  {
    estimator.setThrust(t, thrust);
    ASSERT_EQ(estimator.advance(t, ends).status, Status::OK);
  }
  EXPECT_LT((estimator.estimate().vehicle.position - place).norm(), 1e-3) << "in a minute";
}

TEST(FreeVehicle, IsTowedToTheSteadyState)
{
  Config config = towedFish();
  config.vehicle.attachment = core::Vector3::Zero();
  TetherEstimator towed(config), steady(config);
  const core::Vector3 velocity(1.5, 0.0, 0.0);
  EndTargets start;
  start.vessel.position = {0.0, 0.0, -1.0};
  ASSERT_TRUE(towed.begin(0.0, start).has_stations);
  for (int k = 1; k <= 10000; ++k)
  {
    const double t = 0.05 * k, ramp = std::min(t / 30.0, 1.0);
    EndTargets now;
    now.vessel.velocity = ramp * velocity;
    now.vessel.position = start.vessel.position + (t < 30.0 ? 0.5 * ramp * t : t - 15.0) * velocity;
    ASSERT_EQ(towed.advance(t, now).status, Status::OK) << t;
  }
  start.vessel.velocity = velocity;
  ASSERT_TRUE(steady.begin(0.0, start).has_stations);
  EXPECT_NEAR(towed.estimate().vessel_tension, steady.estimate().vessel_tension,
              1e-3 * steady.estimate().vessel_tension);
  EXPECT_NEAR(towed.estimate().vehicle.position.z(), steady.estimate().vehicle.position.z(), 0.1);
}

TEST(Surroundings, DepthAndObstaclesCanChangeLive)
{
  Config config = testConfig();
  config.environment.seabed = core::Seabed();
  config.environment.seabed->depth = 200.0;
  config.elements = 80;
  EstimatorFixture feeder(config);
  feeder.run(1.0);
  EXPECT_EQ(feeder.estimator.estimate().seabed_contact_length, 0.0);
  EXPECT_TRUE(std::isnan(feeder.estimator.estimate().touchdown_s));
  EXPECT_FALSE(feeder.estimator.setDepth(-1.0));
  ASSERT_TRUE(feeder.estimator.setDepth(75.0));
  feeder.vehicle = {40.0, 0.0, -74.9};
  feeder.estimator.reset();
  const TetherEstimate& e = feeder.run(1.0);
  ASSERT_EQ(e.status, Status::OK) << describe(e.reason);
  EXPECT_GT(e.seabed_contact_length, 5.0);
  EXPECT_GT(e.touchdown_s, 50.0);

  core::Obstacle pile;
  pile.name = "pile";
  pile.shape = core::ObstacleShape::CYLINDER;
  pile.size = {0.5, 200.0, 0.0};
  pile.position = {10.0, -0.7, -40.0};
  pile.velocity = {0.0, 0.25, 0.0};
  EXPECT_TRUE(feeder.estimator.setObstacles(feeder.t, {pile}).empty());
  pile.size[0] = -1.0;
  EXPECT_FALSE(feeder.estimator.setObstacles(feeder.t, {pile}).empty()) << "refused";
  ASSERT_EQ(feeder.run(8.0).status, Status::OK);
  const core::ContactSummary::ObstacleContact& touch = e.contact.obstacles[0];
  EXPECT_GT(touch.total, 0.0);
  EXPECT_LT(touch.force.y(), 0.0) << "the tether holds against it";
  EXPECT_NEAR(touch.place.y(), -0.7 + 2.0 + 0.5, 0.1);
  EXPECT_NEAR(touch.place.x(), 10.0, 0.6);
}

TEST(FreeVehicle, ThrustThatStopsIsStaleAndResetForgetsIt)
{
  EstimatorFixture feeder(towedFish());
  feeder.vehicle_alive = false;
  feeder.run(1.0);
  feeder.estimator.setThrust(feeder.t, {core::Vector3(0.0, 50.0, 0.0), core::Vector3::Zero()});
  EXPECT_EQ(feeder.run(0.8).status, Status::OK);
  EXPECT_EQ(feeder.run(1.0).reason, Reason::VEHICLE_STALE);
  EXPECT_EQ(feeder.run(4.5).status, Status::INVALID);
  feeder.estimator.reset();
  EXPECT_EQ(feeder.estimator.estimate().status, Status::INVALID) << "at once";
  EXPECT_EQ(feeder.run(2.0).status, Status::OK);
  EXPECT_NEAR(feeder.estimator.estimate().vehicle.velocity.y(), 0.0, 0.02) << "thrust was along y";
}

TEST(Surroundings, AnObstacleKeepsItsWayThroughASilence)
{
  Config config = testConfig();
  core::Obstacle ship;
  ship.name = "ship";
  ship.size = {1.0, 0.0, 0.0};
  ship.position = {0.0, 50.0, -10.0};
  ship.velocity = {1.0, 0.0, 0.0};
  config.environment.obstacles = {ship};
  EstimatorFixture feeder(config);
  feeder.run(2.0);
  const double start =
      feeder.estimator.simulation().state.obstacles[0].position.x() + feeder.estimator.simulation().origin().x();
  feeder.vehicle_alive = false;
  ASSERT_EQ(feeder.run(8.0).status, Status::INVALID) << "precondition";
  feeder.vehicle_alive = true;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  EXPECT_NEAR(
      feeder.estimator.simulation().state.obstacles[0].position.x() + feeder.estimator.simulation().origin().x(),
      start + 10.0, 1e-6);
}

TEST(Surroundings, SettlingMovesNoObstacleThatTheTetherPushes)
{
  Config config = testConfig();
  core::Obstacle buoy;
  buoy.size = {2.5, 0.0, 0.0};
  buoy.position = {30.0, 0.0, -48.0};
  double tension[2];
  for (int k = 0; k < 2; ++k)
  {
    buoy.mass = k * 50.0;
    config.environment.obstacles = {buoy};
    TetherEstimator estimator(config);
    EndTargets ends;
    ends.vessel.position = {0.0, 0.0, -10.0};
    ends.vehicle.position = {60.0, 0.0, -10.0};
    ASSERT_TRUE(estimator.begin(0.0, ends).has_stations);
    tension[k] = estimator.estimate().max_tension;
  }
  EXPECT_NEAR(tension[1], tension[0], 1e-3 * tension[0]);
}

TEST(BendLimit, OfASectionIsItsOwn)
{
  Config config = testConfig();
  config.tether.min_bend_radius = 0.3;
  core::CableSection stiff;
  stiff.from = 0.0;
  stiff.to = 100.0;
  stiff.properties = config.tether;
  stiff.properties.min_bend_radius = 30.0;
  config.layout.sections = {stiff};
  EstimatorFixture feeder(config);
  feeder.vehicle = {30.0, 0.0, -10.0};  // hangs in a wide bight
  const TetherEstimate& e = feeder.run(2.0);
  EXPECT_NEAR(e.governing_bend_radius, e.min_bend_radius / 100.0, 1e-9);
}

TEST(VortexShedding, NeedsAFlow)
{
  Config config = towedFish();
  EndTargets ends;
  ends.vessel.velocity = {0.03, 0.0, 0.0};
  TetherEstimator estimator(config);
  ASSERT_TRUE(estimator.begin(0.0, ends).has_stations);
  EXPECT_EQ(estimator.vortexShedding().length, 0.0) << "what creeps makes no vortices that matter";
}

TEST(VortexShedding, AmplifiesDragAndTiltsTheTether)
{
  Config config = towedFish();
  config.vehicle.attachment = core::Vector3::Zero();
  EndTargets ends;
  ends.vessel.velocity = {1.5, 0.0, 0.0};
  double depth[2];
  for (int k = 0; k < 2; ++k)
  {
    config.drag_amplification = k == 0 ? 1.0 : 1.8;
    TetherEstimator estimator(config);
    ASSERT_TRUE(estimator.begin(0.0, ends).has_stations);
    EXPECT_GT(estimator.vortexShedding().length, 50.0);
    // 0.2 V / d of the flow across.
    EXPECT_GT(estimator.vortexShedding().highest_frequency, 10.0);
    EXPECT_LT(estimator.vortexShedding().highest_frequency, 0.2 * 1.5 / 0.012 + 1e-6);
    depth[k] = -estimator.estimate().stations.position.back().z();
  }
  EXPECT_LT(depth[1], 0.95 * depth[0]);
}

}  // namespace tether_monitor::monitor
