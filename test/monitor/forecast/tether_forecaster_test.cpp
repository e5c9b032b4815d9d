#include "tether_monitor/monitor/forecast/tether_forecaster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/navigation_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double HORIZON = 30.0;

// The vehicle drives off under a vessel at rest: in less than half a minute the tether is taut.
EstimatorFixture drivingOff()
{
  EstimatorFixture fixture(coarseConfig());
  fixture.vehicle = {45.0, 0.0, -55.0};
  fixture.vehicle_velocity = {0.6, 0.0, -0.3};
  fixture.run(30.0);
  return fixture;
}

// Time until the estimate passes the limit; infinite if it does not within a minute.
double timeToLimit(EstimatorFixture fixture)
{
  const double begin = fixture.t;
  while (fixture.t < begin + 60.0)
    if (fixture.run(0.05).working_utilisation > 1.0)
      return fixture.t - begin;
  return std::numeric_limits<double>::infinity();
}

// A vehicle whose autopilot keeps it at its place while the vessel goes away from it at 0.5 m/s.
struct HeldByItsAutopilot
{
  HeldByItsAutopilot() : estimator(config()) {}

  static Config config()
  {
    Config c = coarseConfig();
    c.vehicle_mode = VehicleMode::FREE;
    c.vehicle_body = smallVehicle();
    c.vehicle_body.volume = 0.146;
    c.vehicle_body.added_mass = {100.0, 150.0, 150.0};
    c.vehicle_body.center_of_buoyancy = {0.0, 0.0, 0.1};
    c.max_thrust = 3000.0;
    return c;
  }

  const TetherEstimate& run(double duration)
  {
    for (const double end = t + duration; t < end - 1e-9;)
    {
      t += 0.05;
      const core::Vector3 vessel(-0.5 * std::max(t - 130.0, 0.0), 0.0, 1.0);
      estimator.addVessel(PoseMeasurement{t, vessel, Eigen::Quaterniond::Identity()});
      const BodyState& body = estimator.estimate().vehicle;
      core::Wrench thrust;
      if (estimator.estimate().has_vehicle)
      {
        if (t > 110.0)
          place = place.value_or(body.position);
        const core::Vector3 off = body.position - place.value_or(body.position);
        thrust.force = body.orientation.conjugate() * core::Vector3(-150.0 * off - 350.0 * body.velocity);
      }
      estimator.setThrust(t, thrust);
      largest = std::max(largest, estimator.tick(t).max_tension);
    }
    return estimator.estimate();
  }

  TetherEstimator estimator;
  double t = 100.0, largest = 0.0;
  std::optional<core::Vector3> place;
};
}  // namespace

TEST(TetherForecaster, NothingIsForecastOfNothing)
{
  EXPECT_FALSE(TetherEstimator(testConfig()).forecastStart());
}

TEST(TetherForecaster, WhatRestsWillRest)
{
  EstimatorFixture fixture(coarseConfig());
  const TetherEstimate e = fixture.run(20.0);
  const TetherForecast f = TetherForecaster(coarseConfig()).run(*fixture.estimator.forecastStart(), HORIZON, 16);
  EXPECT_EQ(f.members, 16);
  EXPECT_DOUBLE_EQ(f.t, e.time);
  ASSERT_EQ(f.time.size(), 60u);
  EXPECT_DOUBLE_EQ(f.time.back(), HORIZON);
  EXPECT_EQ(f.probability_over_tension, 0.0);
  EXPECT_EQ(f.probability_breaking, 0.0);
  EXPECT_TRUE(std::isnan(f.time_to_limit));
  EXPECT_NEAR(f.vessel_tension.front(), e.vessel_tension, 0.05 * e.vessel_tension);
}

// Against what comes: the fixture runs on with the real motion.
TEST(TetherForecaster, KnowsWhenATetherGetsTaut)
{
  EstimatorFixture fixture = drivingOff();
  ASSERT_LT(fixture.estimator.estimate().working_utilisation, 0.5) << "precondition: not yet";
  const TetherForecast f = TetherForecaster(coarseConfig()).run(*fixture.estimator.forecastStart(), HORIZON, 64);
  const double real = timeToLimit(fixture);
  ASSERT_LT(real, HORIZON - 5.0) << "precondition";
  ASSERT_GT(real, 5.0) << "precondition";
  EXPECT_GT(f.probability_over_tension, 0.9);
  EXPECT_NEAR(f.time_to_limit, real, 2.0);
  EXPECT_LE(f.time_to_limit_p05, f.time_to_limit);
  EXPECT_LE(f.time_to_warning, f.time_to_limit);
  EXPECT_GT(f.max_tension_p95.back(), f.max_tension_p05.back());
}

// Its thrust of the moment would let it be towed along.
TEST(TetherForecaster, AnAutopilotDoesNotGiveWay)
{
  HeldByItsAutopilot dive;
  while (dive.t < 400.0 && !(dive.run(1.0).vehicle_tension > 150.0))
  {
  }
  ForecastStart start = *dive.estimator.forecastStart();
  ASSERT_TRUE(start.reaction);
  const TetherForecast f = TetherForecaster(HeldByItsAutopilot::config()).run(start, HORIZON, 32);
  start.reaction.reset();
  const TetherForecast held = TetherForecaster(HeldByItsAutopilot::config()).run(start, HORIZON, 32);
  dive.largest = 0.0;
  dive.run(HORIZON);
  const auto largest = [](const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); };
  EXPECT_GT(largest(f.max_tension_p95), 0.75 * dive.largest)
      << "what along x is a stick, and what an autopilot, is not known";
  EXPECT_LT(largest(held.max_tension_p95), 0.6 * dive.largest)
      << "what a forecast would say that holds the thrust";
  EXPECT_GT(largest(f.max_tension), 1.4 * largest(held.max_tension));
}

// A heavy vehicle hangs from a vessel that heaves by a metre, and the winch takes that off: what it does at the
// moment of a forecast says nothing of the next half minute.
TEST(TetherForecaster, AWinchGoesOnFollowingTheWaves)
{
  Config config = coarseConfig();
  config.vehicle_mode = VehicleMode::FREE;
  config.vehicle_body = smallVehicle();
  config.vehicle_body.added_mass = {100.0, 400.0, 400.0};
  TetherEstimator estimator(config);
  double t = 100.0, largest = 0.0;
  const auto run = [&](double duration)
  {
    for (const double end = t + duration; t < end - 1e-9;)
    {
      t += 0.05;
      const double growth = std::min((t - 100.0) / 10.0, 1.0), angle = 2.0 * M_PI * t / 6.0;
      const double heave = growth * std::sin(angle);
      estimator.addVessel(
          PoseMeasurement{t, core::Vector3(0.0, 0.0, 1.0 + heave), Eigen::Quaterniond::Identity()});
      estimator.addPayout(t, 80.0 + heave, growth * 2.0 * M_PI / 6.0 * std::cos(angle));
      largest = std::max(largest, estimator.tick(t).max_tension);
    }
  };
  run(60.0);
  TetherForecaster forecaster(config);
  const auto largestOf = [](const std::vector<double>& x) { return *std::max_element(x.begin(), x.end()); };
  std::vector<double> now, without;
  for (int k = 0; k < 4; ++k)
  {
    ForecastStart start = *estimator.forecastStart();
    now.push_back(largestOf(forecaster.run(start, HORIZON, 32).max_tension_p95));
    start.winch.clear();
    without.push_back(largestOf(forecaster.run(start, HORIZON, 32).max_tension_p95));
    run(1.5);
  }
  largest = 0.0;
  run(HORIZON);
  EXPECT_LT(largestOf(now), 2.0 * largest) << "members begin with the errors of the moment";
  EXPECT_GT(*std::min_element(now.begin(), now.end()), 0.9 * largest);
  EXPECT_GT(largestOf(without), 5.0 * largest) << "what a forecast would say that holds the rate of the moment";
}

// What is paid out prevents it, and the least rate is between nothing and that.
TEST(TetherForecaster, PayingOutHelps)
{
  const EstimatorFixture fixture = drivingOff();
  const ForecastStart start = *fixture.estimator.forecastStart();
  TetherForecaster forecaster(coarseConfig());
  ForecastActions pay_out;
  pay_out.payout_rate = 1.0;
  EXPECT_LT(forecaster.run(start, HORIZON, 32, pay_out).probability_over_tension, 0.05);
  const double least = forecaster.leastPayoutRate(start, HORIZON, 32, 0.0, 1.0);
  EXPECT_GT(least, 0.1);
  EXPECT_LT(least, 1.0);
  pay_out.payout_rate = 0.7 * least;
  EXPECT_GT(forecaster.run(start, HORIZON, 32, pay_out).probability_over_tension, 0.05);
}

// A held end that goes on beyond the tether's reach would give any tension.
TEST(TetherForecaster, WhatPartsPullsNoMore)
{
  const EstimatorFixture fixture = drivingOff();
  const TetherForecast f = TetherForecaster(coarseConfig()).run(*fixture.estimator.forecastStart(), 60.0, 16);
  EXPECT_GT(f.probability_breaking, 0.9);
  EXPECT_LT(f.max_tension.back(), 4.0 * coarseConfig().tether.breaking_load);
}

TEST(TetherForecaster, AVesselAtRestHasNoSpeedToRecommend)
{
  const EstimatorFixture fixture = drivingOff();
  EXPECT_TRUE(std::isnan(
      TetherForecaster(coarseConfig()).largestVesselSpeed(*fixture.estimator.forecastStart(), HORIZON, 8, 2.0)));
}

// The members of the ensemble go on, each as it is: at first they are as far apart as the estimate says.
TEST(TetherForecaster, MembersOfAnEnsembleGoOn)
{
  NavigationFixture fixture;
  const TetherEstimate e = fixture.run(60.0);
  ASSERT_TRUE(e.has_stations) << describe(e.reason);
  const ForecastStart start = *fixture.estimator.forecastStart();
  EXPECT_EQ(start.members.size(), 64u);
  const TetherForecast f = TetherForecaster(observedConfig()).run(start, HORIZON, 64);
  EXPECT_EQ(f.members, 64);
  EXPECT_NEAR(f.vessel_tension.front(), e.vessel_tension, 2.0 * e.vessel_tension_stddev);
  EXPECT_GT(f.max_tension_p95.front() - f.max_tension_p05.front(), e.vessel_tension_stddev);
  const TetherEstimate later = fixture.run(HORIZON);
  ASSERT_EQ(f.position.size(), later.stations.position.size());
  EXPECT_LT((f.position.front() - later.stations.position.front()).norm(), 3.0);
  EXPECT_LT((f.position.back() - later.stations.position.back()).norm(), 20.0)
      << "a member's: an unknown 64 N moves 400 N that hang at 100 m by some 15 m";
}

// (F7): a load cell reads less than the members have.
TEST(TetherForecaster, WhatTheLoadCellReadsGoesOn)
{
  NavigationFixture fixture;
  fixture.run(30.0);
  ForecastStart start = *fixture.estimator.forecastStart();
  TetherForecaster forecaster(observedConfig());
  const TetherForecast as_modelled = forecaster.run(start, HORIZON, 32);
  for (ForecastMember& member : start.members)
  {
    EXPECT_EQ(member.tension_ratio, 1.0) << "without a load cell";
    member.tension_ratio = 0.8;
  }
  const TetherForecast as_read = forecaster.run(start, HORIZON, 32);
  for (std::size_t k = 0; k < as_read.time.size(); ++k)
  {
    EXPECT_NEAR(as_read.vessel_tension[k], 0.8 * as_modelled.vessel_tension[k], 1e-6);
    EXPECT_NEAR(as_read.max_tension_p95[k], 0.8 * as_modelled.max_tension_p95[k], 1e-6);
  }
}

TEST(TetherForecaster, TheSameStartGivesTheSameForecast)
{
  const EstimatorFixture fixture = drivingOff();
  const ForecastStart start = *fixture.estimator.forecastStart();
  TetherForecaster a(coarseConfig()), b(coarseConfig());
  b.run(start, 5.0, 4);
  EXPECT_EQ(a.run(start, HORIZON, 16).max_tension_p95, b.run(start, HORIZON, 16).max_tension_p95);
}
// At rest now; in ten seconds the vessel is to leave, and the tether will not reach.
TEST(TetherForecaster, FollowsAPlan)
{
  EstimatorFixture fixture(coarseConfig());
  fixture.run(20.0);
  const double t = fixture.t;
  TetherForecaster forecaster(coarseConfig());
  ASSERT_EQ(fixture.estimator.setPlan(
                {{t, {0.0, 0.0, 0.0}}, {t + 10.0, {0.0, 0.0, 0.0}}, {t + 60.0, {-100.0, 0.0, 0.0}}}),
            "");
  const TetherForecast planned = forecaster.run(*fixture.estimator.forecastStart(), HORIZON, 16);
  EXPECT_TRUE(planned.from_plan);
  EXPECT_GT(planned.probability_over_tension, 0.9);
  EXPECT_GT(planned.time_to_limit, 12.0) << "not before it leaves";
  ForecastActions stay;
  stay.vessel.velocity = core::Vector3(0.0, 0.0, 0.0);
  const TetherForecast stayed = forecaster.run(*fixture.estimator.forecastStart(), HORIZON, 16, stay);
  EXPECT_FALSE(stayed.from_plan);
  EXPECT_LT(stayed.probability_over_tension, 0.05);
  fixture.estimator.setPlan({});
  EXPECT_FALSE(forecaster.run(*fixture.estimator.forecastStart(), HORIZON, 16).from_plan);
}

// The same departure, but the winch is to pay out as much.
TEST(TetherForecaster, FollowsAPlanOfTheWinch)
{
  EstimatorFixture fixture(coarseConfig());
  fixture.run(20.0);
  fixture.estimator.setPlan({{fixture.t, {0.0, 0.0, 0.0}}, {fixture.t + 60.0, {-60.0, 0.0, 0.0}}});
  TetherForecaster forecaster(coarseConfig());
  const double without = forecaster.run(*fixture.estimator.forecastStart(), HORIZON, 16).probability_over_tension;
  EXPECT_FALSE(fixture.estimator.setPayoutPlan({fixture.t, NAN, INFINITY}));
  ASSERT_TRUE(fixture.estimator.setPayoutPlan({fixture.t, 140.0, 1.2}));
  const TetherForecast with = forecaster.run(*fixture.estimator.forecastStart(), HORIZON, 16);
  EXPECT_TRUE(with.from_plan);
  EXPECT_GT(without, 0.9);
  EXPECT_LT(with.probability_over_tension, 0.1);
}

TEST(TetherForecaster, EndsWhenItIsStopped)
{
  EstimatorFixture fixture(coarseConfig());
  fixture.run(20.0);
  const ForecastStart start = *fixture.estimator.forecastStart();
  std::atomic<bool> stop{false};
  TetherForecaster forecaster(coarseConfig());
  forecaster.stopWhen(stop);
  EXPECT_EQ(forecaster.run(start, HORIZON, 8).members, 8);
  stop = true;
  EXPECT_EQ(forecaster.run(start, HORIZON, 8).members, 0);
}

}  // namespace tether_monitor::monitor
