// Mode observed where measurements, settings and messages are unlucky.
#include <gtest/gtest.h>

#include <cmath>

#include "support/navigation_fixture.h"
#include "tether_monitor/monitor/estimator/filtered_vessel_end.h"

namespace tether_monitor::monitor
{
// The vehicle is 8 m aside of where it would hang: good positions say that a force keeps it there, poor ones do
// not.
TEST(ObservedVehicle, TheFirstPositionsCountAsTheirCovarianceSays)
{
  const auto startWith = [](double stddev)
  {
    TetherEstimator estimator(observedConfig());
    for (double t = 0.0; t < 12.0; t += 0.2)
    {
      estimator.addVessel(PoseMeasurement{t, Vector3(0.0, 0.0, 1.0)});
      const Vector3 place(8.0, 1e-3 * t, -98.6);
      estimator.addVehicle(PoseMeasurement{t, MeasuredVector::withStddev(place, Vector3::Constant(stddev))});
    }
    EXPECT_TRUE(estimator.canBegin(12.0));
    estimator.beginFromTracks(12.0);
    EXPECT_TRUE(estimator.isRunning()) << stddev;
    return estimator.simulation().state.q.back().x();
  };
  EXPECT_NEAR(startWith(0.05), 8.0, 0.2);
  EXPECT_LT(startWith(50.0), 4.0);
}

TEST(ObservedVehicle, BeginsBetweenGivenEndsWithTheConfiguredAccuracy)
{
  TetherEstimator estimator(observedConfig());
  EndTargets ends;
  ends.vessel.position = {0.0, 0.0, 1.0};
  ends.vehicle.position = {8.0, 0.0, -98.5};
  estimator.begin(5.0, ends);
  ASSERT_TRUE(estimator.isRunning());
  EXPECT_GT(estimator.simulation().last_solve.iterations, 0);
  EXPECT_LT((estimator.simulation().state.q.back().head<3>() - ends.vehicle.position).norm(), 0.5);
  EXPECT_NE(estimator.estimate().reason, Reason::VEHICLE_STALE) << "the ends are known at this very time";
}

TEST(ObservedVehicle, AFixAtTheTimeOfASavedStateCounts)
{
  NavigationFixture sea;
  sea.lateness = 1.0;  // on the grid of the ticks
  sea.run(20.0);
  const long before = sea.estimator.vehicle().ensemble()->innovations().accepted;
  sea.run(30.0);
  EXPECT_EQ(sea.estimator.vehicle().ensemble()->innovations().accepted - before, 30);
}

TEST(ObservedVehicle, LongLatencyAtAHighRateIsOnlyWork)
{
  Config config = observedConfig();
  config.rate = 200.0;
  config.navigation.latency = 6.0;
  NavigationFixture slow(config);
  const auto run = [&](int from, int to)
  {
    for (int i = from; i < to; ++i)
    {
      const double t = 0.005 * i;
      if (i % 40 == 0)
        slow.estimator.addVessel(PoseMeasurement{t, slow.vessel});
      if (i % 200 == 37)
        slow.estimator.addVehicle(PoseMeasurement{t, slow.vehicleAt(t - 6.0)});
      const TetherEstimate& e = slow.estimator.tick(t);
      if (t > 30.0)
      {
        ASSERT_NE(e.status, Status::INVALID) << t;
        ASSERT_NEAR(e.vessel_tension, 480.0, 100.0) << t;
      }
    }
  };
  run(0, 12000);
}

TEST(ObservedVehicle, ATetherThatStrumsBeginsWhereTheVehicleIs)
{
  Config config = observedConfig();
  config.drag_amplification = 2.0;
  config.environment.current = core::CurrentProfile(Vector3(0.3, 0.0, 0.0));
  NavigationFixture sea(config);
  sea.aside = 30.0;
  sea.depth = -90.0;
  for (int i = 0; i < 1000 && !sea.estimator.isRunning(); ++i)
    sea.run(0.05);
  ASSERT_TRUE(sea.estimator.isRunning());
  // It is in motion before the estimate tells of it.
  const CableSimulation& tether = sea.estimator.simulation();
  const BodyState vehicle =
      BodyState::ofNode(tether.state, tether.model.elements(), tether.state.vehicle, config.vehicle.attachment);
  EXPECT_NEAR(tether.origin().x() + vehicle.position.x(), 30.0, 3.0);
}

TEST(ObservedVehicle, OldPositionsDoNotBecomeNewBySettling)
{
  NavigationFixture sea;
  sea.run(40.0);
  sea.vehicle_alive = false;
  sea.t += 3600.0;
  for (int i = 0; i < 600; ++i)
    ASSERT_EQ(sea.run(0.05).status, Status::INVALID);
  EXPECT_EQ(sea.estimator.estimate().reason, Reason::VEHICLE_STALE);
  sea.vehicle_alive = true;
  EXPECT_NE(sea.run(15.0).status, Status::INVALID) << describe(sea.estimator.estimate().reason);
}

TEST(ObservedVehicle, WhatWasNotMeasuredIsNoPosition)
{
  NavigationFixture sea;
  sea.run(40.0);
  sea.vehicle_alive = false;
  const long before = sea.estimator.vehicle().ensemble()->innovations().accepted;
  PoseMeasurement attitude, depth;
  for (int i = 0; i < 400; ++i)
  {
    attitude.t = depth.t = sea.t;
    depth.position =
        MeasuredVector::withStddev({0.0, 0.0, sea.depth + 0.01 * std::sin(7.0 * i)}, Vector3::Constant(0.1));
    depth.position.setNotMeasured(0);
    depth.position.setNotMeasured(1);
    EXPECT_EQ(sea.estimator.addVehicle(attitude), Rejection::NONE);
    if (i >= 200 && i % 4 == 0)
    {
      EXPECT_EQ(sea.estimator.addVehicle(depth), Rejection::NONE);
    }
    sea.run(0.05);
  }
  EXPECT_EQ(sea.estimator.estimate().reason, Reason::VEHICLE_STALE) << "nobody has seen where it is";
  EXPECT_NEAR(sea.estimator.vehicle().ensemble()->innovations().accepted - before, 50, 2) << "the depths";
}

TEST(ObservedVehicle, AWildVelocityOfTheVesselIsNotFollowed)
{
  NavigationFixture sea;
  sea.run(60.0);
  for (const double wild : {50.0, 1000.0, 1e200})
  {
    sea.estimator.addVessel(TwistMeasurement{sea.t - 0.01, Vector3(wild, 0, 0)});
    for (int i = 0; i < 100; ++i)
    {
      const TetherEstimate& e = sea.run(0.05);
      ASSERT_NE(e.status, Status::INVALID) << wild;
      ASSERT_NEAR(e.vessel_tension, 480.0, 100.0) << wild;
    }
  }
  EXPECT_GE(dynamic_cast<const FilteredVesselEnd&>(sea.estimator.vessel()).filter().outliers(), 3);
}

TEST(ObservedVehicle, ALateFixDoesNotUndoAnObstacle)
{
  Config config = observedConfig();
  core::Obstacle pile;
  pile.name = "pile";
  pile.shape = core::ObstacleShape::CYLINDER;
  pile.size = {0.5, 200.0, 0.0};
  pile.position = {30.0, 0.0, -50.0};
  config.environment.obstacles = {pile};
  NavigationFixture sea(config);
  sea.run(30.0);
  pile.position.x() = 20.0;
  ASSERT_TRUE(sea.estimator.setObstacles(sea.t, {pile}).empty());
  sea.run(0.1);
  sea.fix(sea.t - 1.0);
  sea.run(0.1);
  EXPECT_NEAR(sea.estimator.simulation().state.obstacles[0].position.x() + sea.estimator.simulation().origin().x(),
              20.0, 1e-6);
}

TEST(ObservedVehicle, AfterAnHourTheEnsembleStillHasItsSpread)
{
  Config config = observedConfig();
  config.rate = 5.0;
  config.solver.step = 0.2;
  NavigationFixture sea(config);
  for (int i = 0; i < 18000; ++i)
  {
    const double t = 0.2 * i;
    sea.estimator.addVessel(PoseMeasurement{t, Vector3(sea.vessel + 0.02 * sea.noise())});
    if (i % 5 == 0)
      sea.fix(t);
    sea.estimator.tick(t);
  }
  const TetherEstimate& e = sea.estimator.estimate();
  ASSERT_NE(e.status, Status::INVALID) << describe(e.reason);
  for (const ParameterEstimate& p : sea.estimator.parameters())
  {
    if (p.name.find("current") != std::string::npos)
    {
      EXPECT_GT(p.stddev, 0.1 * p.configured_stddev) << p.name << ": it hangs where the current lets it";
    }
    else if (p.name != "tether.length")
    {
      EXPECT_GT(p.stddev, 0.4 * p.configured_stddev) << p.name;
    }
    EXPECT_LT(std::abs(p.mean - p.configured), 3.0 * p.configured_stddev) << p.name;
  }
  EXPECT_EQ(sea.estimator.vehicle().ensemble()->filter().resets(), 0);
}

TEST(ObservedVehicle, AVehicleInTheAirIsNeverFine)
{
  NavigationFixture sea;
  sea.depth = 60.0;
  for (int i = 0; i < 800; ++i)
    ASSERT_NE(sea.run(0.05).status, Status::OK) << sea.t;
  EXPECT_TRUE(sea.estimator.findings().holds(Subject::VEHICLE, Implausibility::IMPROBABLE_FORCE, sea.t, 60.0) ||
              sea.estimator.findings().holds(Subject::VEHICLE, Implausibility::VEHICLE_ABOVE_WATER, sea.t, 60.0));
}

TEST(ObservedVehicle, ALengthThatIsFarOffIsNamed)
{
  // It hangs 4 m lower than its tether is long: 5 standard deviations.
  NavigationFixture sea;
  sea.depth = -103.0;
  int fine = 0;
  for (int i = 0; i < 2400; ++i)
    fine += sea.run(0.05).status == Status::OK;
  EXPECT_LT(fine, 200) << "while it learns";
  EXPECT_TRUE(sea.estimator.findings().holds(Subject::TETHER, Implausibility::IMPROBABLE_LENGTH, sea.t, 60.0));
}

TEST(ObservedVehicle, ALoadCellMakesTheBandNarrowerAndItsBiasIsKnownToBeThere)
{
  Config config = observedConfig();
  config.navigation.force_stddev = 150.0;
  NavigationFixture without(config), with(config);
  without.run(60.0);
  double tension = without.estimator.estimate().vessel_tension;
  const double bias = 30.0;
  for (int i = 0; i < 1200; ++i)
  {
    with.run(0.05);
    if (i % 2 == 0)
    {
      ASSERT_EQ(with.estimator.addTension(with.t, 480.0 + bias + 5.0 * with.noise().x()), Rejection::NONE);
    }
  }
  const TetherEstimate& e = with.estimator.estimate();
  EXPECT_LT(e.vessel_tension_stddev, without.estimator.estimate().vessel_tension_stddev);
  EXPECT_NEAR(e.vessel_tension, 480.0, 2.5 * e.vessel_tension_stddev) << "without it " << tension;
  EXPECT_GT(e.vessel_tension_stddev, 20.0) << "a bias of 2 % of 5000 N is not known away";
  EXPECT_EQ(with.estimator.addTension(with.t, NAN), Rejection::NOT_FINITE);
  EXPECT_EQ(with.estimator.addDirection(with.t, Vector3::Zero()), Rejection::NOT_FINITE);
  EXPECT_EQ(with.estimator.addDirection(with.t, Vector3(0.0, 0.01, -1.0)), Rejection::NONE);
  EXPECT_NE(with.run(1.0).status, Status::INVALID);
}
}  // namespace tether_monitor::monitor
