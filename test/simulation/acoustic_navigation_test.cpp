#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "support/scenario_files.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/simulation/heave_sensor.h"
#include "tether_monitor/simulation/position_sensor.h"

namespace tether_monitor::simulation
{
namespace
{
constexpr double TICK = 0.05;  // [s]

struct Moment
{
  double t = 0.0;
  monitor::BodyState vessel, vehicle;
  double tension = 0.0;
};

std::vector<Moment> play(const ScenarioFile& scenario, double duration)
{
  Simulator simulator(scenario.config, scenario.simulation);
  std::vector<Moment> moments;
  for (int i = 1; i * TICK <= duration; ++i)
  {
    EXPECT_TRUE(simulator.advance(i * TICK));
    moments.push_back({i * TICK, simulator.vessel(), simulator.vehicle(), simulator.endForces().vessel.norm()});
  }
  return moments;
}

// @param stddev  NaN: not told.
monitor::PoseMeasurement measured(double t, const monitor::BodyState& body, double stddev)
{
  monitor::PoseMeasurement m;
  m.t = t;
  m.position = body.position;
  if (!std::isnan(stddev))
    m.position = monitor::MeasuredVector::withStddev(body.position, core::Vector3::Constant(stddev));
  m.orientation = body.orientation;
  return m;
}

struct Score
{
  double rms = 0.0, ok = 0.0, within_1 = 0.0, within_2 = 0.0;
  double invalid = 0.0;  // [s]
  bool alarmed =
      false;  // for the tension: its limit; the warning looks at the edge of the band, which is wide at first
};

// Times [s]: from `begin` on there are measurements, between `lost_from` and `lost_to` none of the vessel.
struct Plan
{
  double begin = 0.0, count_from = 0.0, lost_from = 0.0, lost_to = 0.0;
};

// As the node does it, but every message arrives in time.
Score observe(const ScenarioFile& scenario, const std::vector<Moment>& moments, unsigned seed, const Plan& when)
{
  const SimulationConfig& plan = scenario.simulation;
  Sensor satellites(plan.vessel_sensor, seed), acoustics(plan.vehicle_sensor, seed + 1);
  HeaveSensor heave(plan.heave, seed + 2);
  monitor::Config config = scenario.config;
  config.uncertainty.members = 64;
  config.elements = 10;
  monitor::TetherEstimator estimator(config);
  double n = 0.0, invalid = 0.0, mean = 0.0, square = 0.0, ok = 0.0, one = 0.0, two = 0.0;
  bool alarmed = false;
  for (const Moment& now : moments)
  {
    const auto positions = satellites.sample(now.t, now.vessel), fixes = acoustics.sample(now.t, now.vehicle);
    const auto height = heave.sample(now.t, now.vessel);
    if (now.t < when.begin)
      continue;
    const bool is_lost = now.t > when.lost_from && now.t < when.lost_to;
    for (const Measurement& m : is_lost ? std::vector<Measurement>() : positions)
      estimator.addVessel(measured(m.time, m.body, plan.vessel_sensor.position_stddev));
    if (height && !is_lost)
    {
      monitor::PoseMeasurement m = measured(now.t, now.vessel, plan.heave.stddev);
      m.position = m.position.at({0.0, 0.0, *height});
      m.position.setNotMeasured(0);
      m.position.setNotMeasured(1);
      estimator.addVessel(m);
    }
    for (const Measurement& m : fixes)
      estimator.addVehicle(measured(m.time, m.body, std::nan("")));
    const monitor::TetherEstimate& e = estimator.tick(now.t);
    for (const monitor::Alarm& alarm : estimator.alarms().alarms())
      alarmed = alarmed || (alarm.isAnnunciated() && alarm.definition().name == "over_tension");
    if (now.t < when.count_from)
      continue;
    invalid += e.status == monitor::Status::INVALID;
    if (e.status == monitor::Status::INVALID)
      continue;
    const double error = std::abs(e.vessel_tension - now.tension);
    n += 1.0;
    mean += now.tension;
    square += error * error;
    ok += e.status == monitor::Status::OK;
    one += error <= e.vessel_tension_stddev;
    two += error <= 2.0 * e.vessel_tension_stddev;
  }
  return {std::sqrt(square / n) / (mean / n), ok / (n + invalid), one / n, two / n, invalid * TICK, alarmed};
}
}  // namespace

// The ship surges and pitches by a metre, seen five times a second; the drag is a fifth higher than told.
TEST(AcousticNavigation, KnowsTheTensionInASeaway)
{
  const ScenarioFile scenario("acoustic_navigation");
  const std::vector<Moment> moments = play(scenario, 350.0);
  double rms = 0.0, one = 0.0, two = 0.0;
  int runs = 0;
  for (const double begin : {100.0, 200.0})
    for (const unsigned seed : {11u, 12u})
    {
      const Score score = observe(scenario, moments, seed, {begin, begin + 100.0});
      EXPECT_GT(score.ok, 0.98) << seed << " from " << begin;
      EXPECT_FALSE(score.alarmed) << seed << " from " << begin;
      EXPECT_LT(score.rms, 0.25) << seed << " from " << begin;
      rms += score.rms;
      one += score.within_1;
      two += score.within_2;
      ++runs;
    }
  EXPECT_LT(rms / runs, 0.2);
  EXPECT_GT(one / runs, 0.5);
  EXPECT_GT(two / runs, 0.9);
}

// No filter predicts the stern of a ship in an irregular sea: what it does not follow is in the band.
TEST(AcousticNavigation, TheBandHoldsInAnIrregularSea)
{
  const ScenarioFile scenario("dive");
  const std::vector<Moment> moments = play(scenario, 150.0);
  double one = 0.0, two = 0.0;
  const std::vector<unsigned> seeds{31u, 32u};
  for (const unsigned seed : seeds)
  {
    const Score score = observe(scenario, moments, seed, {0.0, 60.0});
    EXPECT_LT(score.rms, 0.25) << seed;
    EXPECT_LT(score.invalid, 40.0) << seed << ": a band that is too wide says so";
    one += score.within_1 / seeds.size();
    two += score.within_2 / seeds.size();
  }
  EXPECT_GT(one, 0.55);
  EXPECT_GT(two, 0.88);
}

// It begins while the waves throw ship and tether into a motion that is far from any steady state.
TEST(AcousticNavigation, BeginsInTheMiddleOfATransient)
{
  const ScenarioFile scenario("acoustic_navigation");
  const std::vector<Moment> moments = play(scenario, 200.0);
  double rms = 0.0, two = 0.0;
  int runs = 0;
  for (const unsigned seed : {21u, 22u, 23u})
  {
    const Score score = observe(scenario, moments, seed, {0.0, 100.0});
    EXPECT_GT(score.ok, 0.95) << seed;
    EXPECT_FALSE(score.alarmed) << seed << ": the peaks are half the working load";
    EXPECT_LT(score.rms, 0.25) << seed;
    rms += score.rms;
    two += score.within_2;
    ++runs;
  }
  EXPECT_LT(rms / runs, 0.2);
  EXPECT_GT(two / runs, 0.9);
}

// The satellites fail for longer than the vehicle may go on: it looks at the waves anew before it says anything.
TEST(AcousticNavigation, BeginsAnewAfterTheVesselWasLost)
{
  const ScenarioFile scenario("acoustic_navigation");
  const std::vector<Moment> moments = play(scenario, 230.0);
  double rms = 0.0, two = 0.0;
  int runs = 0;
  for (const double lost_to : {165.0, 168.0})
    for (const unsigned seed : {31u})
    {
      const Score score = observe(scenario, moments, seed, {20.0, lost_to, lost_to - 40.0, lost_to});
      EXPECT_GT(score.invalid, 9.0) << seed << " until " << lost_to;
      EXPECT_LT(score.invalid, 26.0) << seed << " until " << lost_to;
      EXPECT_LT(score.rms, 0.25) << seed << " until " << lost_to;
      rms += score.rms;
      two += score.within_2;
      ++runs;
    }
  EXPECT_LT(rms / runs, 0.2);
  EXPECT_GT(two / runs, 0.9);
}

}  // namespace tether_monitor::simulation
