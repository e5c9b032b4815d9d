// The whole of mode observed, through the façade: measurements late, out of order, twice; lever arms; gaps;
// saving.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/navigation_fixture.h"

namespace tether_monitor::monitor
{
TEST(ObservedVehicle, SaysWhatItWaitsFor)
{
  NavigationFixture sea;
  sea.vehicle_alive = false;
  EXPECT_EQ(sea.run(8.0).reason, Reason::NO_INPUT) << "no position of the vehicle";
  sea.vehicle_alive = true;
  EXPECT_EQ(sea.run(1.5).reason, Reason::SETTLING) << "one position is not enough to begin with";
  EXPECT_NE(sea.run(10.0).status, Status::INVALID);
}

TEST(ObservedVehicle, FollowsWithoutSpikesAndKnowsHowSureItIs)
{
  NavigationFixture sea;
  ASSERT_NE(sea.run(60.0).status, Status::INVALID);
  double square = 0.0, worst = 0.0;
  int n = 0;
  for (; n < 1200; ++n)
  {
    const TetherEstimate& e = sea.run(0.05);
    const double off = (e.vehicle.position - sea.vehicleAt(sea.t)).norm();
    square += off * off;
    worst = std::max(worst, e.vessel_tension);
    ASSERT_GT(e.vessel_tension_stddev, 0.0);
  }
  EXPECT_LT(std::sqrt(square / n), 0.25) << "better than the positions themselves, 0.35 m";
  EXPECT_LT(worst, 1.3 * sea.run(0.05).vessel_tension);
  EXPECT_EQ(sea.estimator.estimate().status, Status::OK);
  EXPECT_LT(sea.estimator.estimate().vehicle_position_stddev, 0.2);
}

// Where its bight hangs nobody knows: members take turns in being the nearest, and what is shown slides.
TEST(ObservedVehicle, TheShapeOfASlackTetherDoesNotLeap)
{
  Config config = observedConfig();
  config.uncertainty.current = 0.3;
  NavigationFixture sea(config);
  sea.depth = -60.0;
  sea.aside = 15.0;
  ASSERT_NE(sea.run(60.0).status, Status::INVALID);
  std::vector<Vector3> before = sea.estimator.estimate().stations.position;
  double farthest = 0.0, doubt = 0.0;
  for (int n = 0; n < 6000; ++n)
  {
    const TetherEstimate& e = sea.run(0.05);
    ASSERT_EQ(e.stations.position.size(), before.size());
    for (std::size_t k = 0; k < before.size(); ++k)
    {
      farthest = std::max(farthest, (e.stations.position[k] - before[k]).norm());
      doubt = std::max(doubt, e.position_stddev[k].norm());
    }
    before = e.stations.position;
  }
  EXPECT_GT(doubt, 3.0) << "of the place, so that it could";
  EXPECT_LT(farthest, 1.0) << "in a twentieth of a second; without fading 38 m";
}

TEST(ObservedVehicle, LateMeasurementsGiveTheSameAsThoseInTime)
{
  for (const double latency : {1.0, 2.5})
  {
    NavigationFixture sea;
    sea.run(20.0);
    TetherEstimator late = sea.estimator;
    // A minute of the same measurements, which come late in one case; then they have all come.
    std::vector<PoseMeasurement> fixes;
    std::size_t sent = 0;
    const double begin = sea.t;
    for (int i = 1; i <= 1200; ++i)
    {
      const double t = sea.t = begin + 0.05 * i;
      const PoseMeasurement vessel{t, sea.vessel};
      if (i % 4 == 0)
        for (TetherEstimator* each : {&sea.estimator, &late})
          each->addVessel(vessel);
      if (i % 20 == 10 && i < 1200 - 20 * latency)
      {
        fixes.push_back({t, Vector3(sea.vehicleAt(t) + 0.2 * sea.noise())});
        sea.estimator.addVehicle(fixes.back());
      }
      if (sent < fixes.size() && fixes[sent].t <= t - latency)
      {
        ASSERT_EQ(late.addVehicle(fixes[sent++]), Rejection::NONE);
      }
      sea.estimator.tick(t);
      late.tick(t);
    }
    EXPECT_EQ(sent, fixes.size());
    const TetherEstimate &a = sea.estimator.estimate(), &b = late.estimate();
    EXPECT_LT((a.vehicle.position - b.vehicle.position).norm(), 0.5 * a.vehicle_position_stddev) << latency;
    EXPECT_NEAR(a.vessel_tension, b.vessel_tension, 0.1 * a.vessel_tension_stddev) << latency;
    EXPECT_NEAR(a.vessel_tension_stddev, b.vessel_tension_stddev, 0.1 * a.vessel_tension_stddev) << latency;
  }
}

TEST(ObservedVehicle, OrderOfArrivalDoesNotMatter)
{
  NavigationFixture sea;
  sea.run(30.0);
  TetherEstimator other = sea.estimator;
  const double t = sea.t;
  const PoseMeasurement first{t - 0.8, Vector3(sea.vehicleAt(t - 0.8) + Vector3(0.3, 0, 0))},
      second{t - 0.4, Vector3(sea.vehicleAt(t - 0.4) - Vector3(0.2, 0, 0))};
  EXPECT_EQ(sea.estimator.addVehicle(first), Rejection::NONE);
  EXPECT_EQ(sea.estimator.addVehicle(second), Rejection::NONE);
  EXPECT_EQ(other.addVehicle(second), Rejection::NONE);
  EXPECT_EQ(other.addVehicle(first), Rejection::NONE);
  EXPECT_EQ(other.addVehicle(first), Rejection::REPEATED);
  const TetherEstimate a = sea.estimator.tick(t + 0.05), b = other.tick(t + 0.05);
  EXPECT_EQ(a.vessel_tension, b.vessel_tension);
  EXPECT_EQ(a.vehicle.position, b.vehicle.position);
  EXPECT_EQ(a.vessel_tension_stddev, b.vessel_tension_stddev);

  // And one that comes a tick later than the other, over ground that was already covered.
  EXPECT_EQ(sea.estimator.addVehicle(PoseMeasurement{t - 0.2, sea.vehicleAt(t)}), Rejection::NONE);
  sea.estimator.tick(t + 0.1);
  EXPECT_EQ(sea.estimator.addVehicle(PoseMeasurement{t - 0.6, sea.vehicleAt(t)}), Rejection::NONE);
  EXPECT_EQ(other.addVehicle(PoseMeasurement{t - 0.6, sea.vehicleAt(t)}), Rejection::NONE);
  EXPECT_EQ(other.addVehicle(PoseMeasurement{t - 0.2, sea.vehicleAt(t)}), Rejection::NONE);
  other.tick(t + 0.1);
  const TetherEstimate c = sea.estimator.tick(t + 0.15), d = other.tick(t + 0.15);
  EXPECT_NEAR(c.vessel_tension, d.vessel_tension, 0.1 * c.vessel_tension_stddev);
  EXPECT_LT((c.vehicle.position - d.vehicle.position).norm(), 0.1 * c.vehicle_position_stddev);
}

TEST(ObservedVehicle, TooLateIsRefusedByName)
{
  NavigationFixture sea;
  sea.run(40.0);
  EXPECT_EQ(sea.fix(sea.t - 10.0), Rejection::TOO_LATE);
  Config config = observedConfig();
  config.navigation.latency = 10.0;
  NavigationFixture slow(config);
  slow.run(60.0);
  EXPECT_EQ(slow.fix(slow.t - 0.01), Rejection::NONE) << "it was true ten seconds ago, as told";
}

TEST(ObservedVehicle, RepeatedDigitsAreAStoppedSource)
{
  NavigationFixture sea;
  sea.run(30.0);
  for (int i = 1; i <= 2; ++i)
  {
    sea.run(0.5);
    EXPECT_EQ(sea.estimator.addVehicle(PoseMeasurement{sea.t, Vector3(0, 0, -97)}), Rejection::NONE);
    sea.vehicle_alive = false;
  }
  sea.run(0.5);
  EXPECT_EQ(sea.estimator.addVehicle(PoseMeasurement{sea.t, Vector3(0, 0, -97)}), Rejection::FROZEN);
}

TEST(ObservedVehicle, CoastsDegradesAndEnds)
{
  NavigationFixture sea;
  sea.run(60.0);
  ASSERT_EQ(sea.estimator.estimate().status, Status::OK);
  const double sure = sea.estimator.estimate().vehicle_position_stddev;
  sea.vehicle_alive = false;
  EXPECT_EQ(sea.run(6.0).reason, Reason::VEHICLE_STALE);
  EXPECT_EQ(sea.estimator.estimate().status, Status::DEGRADED);
  EXPECT_GT(sea.estimator.estimate().vehicle_position_stddev, 1.5 * sure);
  EXPECT_EQ(sea.run(20.0).status, Status::INVALID);
  EXPECT_EQ(sea.estimator.estimate().reason, Reason::VEHICLE_STALE);
  EXPECT_TRUE(std::isnan(sea.estimator.estimate().vessel_tension));
  EXPECT_TRUE(std::isnan(sea.estimator.estimate().vessel_tension_stddev));
  sea.vehicle_alive = true;
  EXPECT_NE(sea.run(8.0).status, Status::INVALID) << "it has coasted on";
}

TEST(ObservedVehicle, ABandThatIsTooWideIsUncertain)
{
  Config config = observedConfig();
  config.tether.working_load = 300.0;
  config.tether.breaking_load = 20000.0;
  config.navigation.force_stddev = 2000.0;
  config.navigation.degraded_stddev = 0.001;
  config.navigation.invalid_stddev = 10.0;
  NavigationFixture sea(config);
  EXPECT_EQ(sea.run(60.0).reason, Reason::UNCERTAIN);
  config.navigation.invalid_stddev = 0.001;
  NavigationFixture hopeless(config);
  EXPECT_EQ(hopeless.run(60.0).status, Status::INVALID);
  EXPECT_EQ(hopeless.estimator.estimate().reason, Reason::UNCERTAIN);
}

// The threshold lies in the middle of what the band does.
TEST(ObservedVehicle, AStatusDoesNotFlickerAboutItsThreshold)
{
  Config config = observedConfig();
  std::vector<double> widths;
  NavigationFixture first(config);
  first.run(60.0);
  for (int k = 0; k < 1200; ++k)
  {
    const TetherEstimate& e = first.run(0.05);
    widths.push_back(std::max(e.vessel_tension_stddev, e.vehicle_tension_stddev));
  }
  std::vector<double> sorted = widths;
  std::sort(sorted.begin(), sorted.end());
  const double middle = sorted[sorted.size() / 2];
  int crossings = 0, changes = 0;
  for (std::size_t k = 1; k < widths.size(); ++k)
    crossings += (widths[k] > middle) != (widths[k - 1] > middle);

  config.navigation.degraded_stddev = middle / config.tether.working_load;
  NavigationFixture second(config);
  Status before = second.run(60.0).status;
  for (int k = 0; k < 1200; ++k)
  {
    const Status now = second.run(0.05).status;
    changes += now != before;
    before = now;
  }
  EXPECT_GT(crossings, 20);
  EXPECT_LT(4 * changes, crossings);
}

TEST(ObservedVehicle, FindsAForceThatNobodyTold)
{
  // Held 20 m aside of where it would hang: by some 100 N on a body that weighs 406 N in water.
  Config config = observedConfig();
  config.uncertainty.current = 0.02;  // or it might be a current
  config.navigation.force_stddev = 150.0;
  NavigationFixture sea(config);
  sea.aside = 20.0;
  sea.depth = 1.0 - std::sqrt(100.05 * 100.05 - 400.0);
  const TetherEstimate& e = sea.run(180.0);
  ASSERT_NE(e.status, Status::INVALID);
  const double weight = 9.81 * (400.0 - 1025.0 * 0.35);
  EXPECT_NEAR(e.disturbance.x(), weight * 20.0 / 98.0, 45.0);
  EXPECT_NEAR(e.disturbance.x(), weight * 20.0 / 98.0, 3.0 * e.disturbance_stddev);
}

TEST(ObservedVehicle, TheWarningLooksAtTheEdgeOfTheBand)
{
  NavigationFixture sea;
  const TetherEstimate& e = sea.run(60.0);
  AlarmSet alarms(sea.estimator.config());
  TetherEstimate near = e;
  near.working_utilisation = 0.7;
  near.max_tension = 0.7 * 5000.0;
  near.vessel_tension_stddev = near.vehicle_tension_stddev = 400.0;
  near.max_tension_p95 = TetherEstimate::NONE;
  for (int i = 0; i < 10; ++i)
  {
    near.time = e.time + 0.05 * i;
    alarms.update(near, AlarmInputs());
  }
  bool warned = false, limit = false;
  for (const Alarm& alarm : alarms.alarms())
  {
    warned = warned || (alarm.definition().name == "over_tension_warning" && alarm.isActive());
    limit = limit || (alarm.definition().name == "over_tension" && alarm.isActive());
  }
  EXPECT_TRUE(warned) << "0.7 + 1.64 * 400 / 5000 > 0.8";
  EXPECT_FALSE(limit);
}

TEST(ObservedVehicle, ALeverArmTurnsWithTheVessel)
{
  Config config = observedConfig();
  config.vessel.attachment = {5.0, 0.0, 2.0};
  NavigationFixture level(observedConfig()), turned(config);
  level.vessel = {0.0, 5.0, 3.0};
  turned.vessel = {0.0, 0.0, 1.0};
  const Eigen::Quaterniond quarter(Eigen::AngleAxisd(M_PI / 2.0, Vector3::UnitZ()));
  for (int i = 0; i < 400; ++i)
  {
    level.t = turned.t = 0.05 * (i + 1);
    level.estimator.addVessel(PoseMeasurement{level.t, level.vessel});
    turned.estimator.addVessel(PoseMeasurement{level.t, turned.vessel, quarter});
    if (i % 20 == 0)
      for (NavigationFixture* sea : {&level, &turned})
        sea->estimator.addVehicle(PoseMeasurement{level.t, Vector3(1e-4 * i, 0.0, -95.0)});
    level.estimator.tick(level.t);
    turned.estimator.tick(level.t);
  }
  ASSERT_TRUE(level.estimator.estimate().has_stations);
  EXPECT_LT((level.estimator.estimate().stations.position.front() - level.vessel).norm(), 1e-3);
  EXPECT_LT((turned.estimator.estimate().stations.position.front() - level.vessel).norm(), 1e-3);
}

TEST(ObservedVehicle, GoesOnBitForBitAfterASave)
{
  NavigationFixture sea;
  sea.lateness = 0.7;
  sea.run(40.0);
  NavigationFixture other(observedConfig());
  ASSERT_TRUE(other.estimator.restore(sea.estimator.save()));
  other.t = sea.t;
  other.ticks = sea.ticks;
  other.lateness = sea.lateness;
  other.generator = sea.generator;
  other.normal = sea.normal;
  sea.run(20.0);
  other.run(20.0);
  EXPECT_EQ(sea.estimator.save(), other.estimator.save());
  EXPECT_EQ(sea.estimator.estimate().vessel_tension, other.estimator.estimate().vessel_tension);
}

TEST(ObservedVehicle, NonsenseIsRefusedAndForgotten)
{
  NavigationFixture sea;
  sea.run(30.0);
  const double nan = TetherEstimate::NONE;
  const double tension = sea.estimator.estimate().vessel_tension;
  EXPECT_EQ(sea.estimator.addVehicle(PoseMeasurement{sea.t, Vector3(nan, 0, 0)}), Rejection::NOT_FINITE);
  EXPECT_EQ(sea.estimator.addVehicle(PoseMeasurement{nan, Vector3(0, 0, -97)}), Rejection::NOT_FINITE);
  EXPECT_EQ(sea.estimator.addVehicle(PoseMeasurement{sea.t, Vector3(0, 0, -97), Eigen::Quaterniond(0, 0, 0, 0)}),
            Rejection::BAD_QUATERNION);
  EXPECT_EQ(sea.estimator.addVessel(PoseMeasurement{sea.t + 0.01, Vector3(0, nan, 0)}), Rejection::NOT_FINITE);
  EXPECT_EQ(sea.estimator.addVessel(TwistMeasurement{sea.t, Vector3(0, nan, 0)}), Rejection::NOT_FINITE);
  for (int i = 0; i < 20; ++i)
    sea.estimator.addVessel(PoseMeasurement{sea.t + 0.001 * i, Vector3(500.0, 0, 0)});
  sea.run(0.05);
  EXPECT_TRUE(sea.estimator.estimate().status != Status::OK ||
              std::abs(sea.estimator.estimate().vessel_tension / tension - 1.0) < 0.2);
  sea.estimator.reset();
  EXPECT_EQ(sea.run(0.05).status, Status::INVALID);
  EXPECT_NE(sea.run(30.0).status, Status::INVALID);
}

TEST(ObservedVehicle, WhatIsUsuallyLateIsNotStale)
{
  NavigationFixture sea;
  sea.lateness = 1.5;
  const TetherEstimate& e = sea.run(60.0);
  EXPECT_GT(e.vehicle_age, 1.0);
  EXPECT_LT(e.vehicle_overdue, 0.5);
  for (const Alarm& alarm : sea.estimator.alarms().alarms())
    EXPECT_FALSE(alarm.definition().name == "stale_input" && alarm.isActive());
  sea.vehicle_alive = false;
  sea.run(8.0);
  bool is_stale = false;
  for (const Alarm& alarm : sea.estimator.alarms().alarms())
    is_stale = is_stale || (alarm.definition().name == "stale_input" && alarm.isActive());
  EXPECT_TRUE(is_stale);
}
}  // namespace tether_monitor::monitor
