#include "tether_monitor/monitor/estimator/alarm_input_tracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
TEST(AlarmInputTracker, MeasuresWhereTheVehicleIs)
{
  EstimatorFixture fixture;
  fixture.run(2.0);
  const AlarmInputs& in = fixture.estimator.alarmInputs().last();
  EXPECT_NEAR(in.lay_back, 60.0, 1e-6);
  EXPECT_NEAR(in.scope, 100.0 / 71.0, 1e-6);
  EXPECT_TRUE(std::isnan(in.touchdown_distance)) << "there is no seabed";
  EXPECT_TRUE(std::isnan(in.obstacle_force)) << "nor an obstacle";
  EXPECT_NEAR(in.turns, 0.0, 1e-12);
}

TEST(AlarmInputTracker, MeasuresHowFastTheTensionRises)
{
  EstimatorFixture fixture;
  fixture.run(5.0);
  fixture.vehicle_velocity = {0.3, 0.0, -0.3};
  fixture.run(2.0);
  const double before = fixture.estimator.estimate().max_tension;
  fixture.run(0.05);
  EXPECT_NEAR(fixture.estimator.alarmInputs().last().tension_rate,
              (fixture.estimator.estimate().max_tension - before) / 0.05, 1e-6);
}

TEST(AlarmInputTracker, FindsTheNearestPointBetweenStations)
{
  Config config = coarseConfig();  // stations 5 m apart
  alarmConfig(config, "obstacle_clearance").limit = 0.5;
  core::Obstacle pile;
  pile.name = "pile";
  pile.shape = core::ObstacleShape::SPHERE;
  pile.size = {0.2, 0.0, 0.0};
  config.environment.obstacles = {pile};
  EstimatorFixture probe(coarseConfig());
  const core::StationProfile at = probe.run(1.0).stations;
  const core::Vector3 middle = 0.5 * (at.position[10] + at.position[11]);
  config.environment.obstacles[0].position = middle + core::Vector3(0.0, 1.0, 0.0);
  EstimatorFixture fixture(config);
  fixture.run(1.0);
  const AlarmInputs& in = fixture.estimator.alarmInputs().last();
  EXPECT_NEAR(in.clearance, 1.0 - 0.2 - 0.006, 1e-3);
  EXPECT_NEAR(in.clearance_s, 0.5 * (at.s[10] + at.s[11]), 0.5);
  EXPECT_DOUBLE_EQ(in.obstacle_force, 0.0);
}

TEST(AlarmInputTracker, FindsTheTouchdown)
{
  Config config = testConfig();
  config.environment.seabed.emplace();
  config.environment.seabed->depth = 50.0;
  EstimatorFixture fixture(config);
  fixture.vehicle = {70.0, 0.0, -49.9};
  fixture.run(5.0);
  const TetherEstimate& e = fixture.estimator.estimate();
  ASSERT_FALSE(std::isnan(e.touchdown_s));
  const double distance = fixture.estimator.alarmInputs().last().touchdown_distance;
  EXPECT_GT(distance, 10.0);
  EXPECT_LT(distance, 70.0 - 0.9 * (100.0 - e.touchdown_s));
}

TEST(AlarmInputTracker, KnowsNothingOfATetherWithoutAnEstimate)
{
  EstimatorFixture fixture;
  fixture.run(2.0);
  fixture.vessel_alive = fixture.vehicle_alive = false;
  fixture.run(8.0);
  ASSERT_EQ(fixture.estimator.estimate().status, Status::INVALID);
  const AlarmInputs& in = fixture.estimator.alarmInputs().last();
  EXPECT_TRUE(std::isnan(in.lay_back));
  EXPECT_TRUE(std::isnan(in.tension_rate));
}

TEST(AlarmInputTracker, TakesWhatOthersKnow)
{
  EstimatorFixture fixture;
  fixture.estimator.report({0.7, 0.9, 0.1});
  EXPECT_TRUE(fixture.estimator.setTurns(3.0));
  fixture.run(1.0);
  const AlarmInputs& in = fixture.estimator.alarmInputs().last();
  EXPECT_DOUBLE_EQ(in.forecast_probability, 0.7);
  EXPECT_DOUBLE_EQ(in.resonance, 0.9);
  EXPECT_DOUBLE_EQ(in.missed_cycles, 0.1);
  EXPECT_NEAR(in.turns, 3.0, 1e-12);
  EXPECT_FALSE(fixture.estimator.setTurns(NAN));
}

}  // namespace tether_monitor::monitor
