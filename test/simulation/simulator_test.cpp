#include "tether_monitor/simulation/simulator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/scenario_files.h"
#include "tether_monitor/core/assembly/contact_summary.h"
#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/solve/steady_state_solver.h"
#include "tether_monitor/simulation/position_sensor.h"

namespace tether_monitor::simulation
{
namespace
{
double yaw(const Eigen::Quaterniond& q)
{
  const core::Vector3 x = q * core::Vector3::UnitX();
  return std::atan2(x.y(), x.x());
}
}  // namespace

TEST(Ship, FloatsAtItsDraftAndRightsItself)
{
  ScenarioFile scenario("heave_in_waves");
  scenario.config.environment.waves = core::SeaState();
  scenario.config.environment.wind.setZero();
  Simulator simulator(scenario.config, scenario.simulation);
  ASSERT_TRUE(simulator.advance(60.0));
  // The weight hangs over the side: it heels and sinks a little, and stays.
  EXPECT_NEAR(simulator.vessel().position.z(), equilibriumHeight(scenario.simulation.vessel.ship), 0.15);
  EXPECT_LT(std::abs(2.0 * simulator.vessel().orientation.x()), 0.1);
  EXPECT_LT(simulator.vessel().position.head<2>().norm(), 2.0) << "dynamic positioning";
}

TEST(Scenarios, TowTurnsAndComesBackToTheSteadyTow)
{
  ScenarioFile scenario("tow_and_turn");
  Simulator simulator(scenario.config, scenario.simulation);
  const double start = simulator.endForces().vessel.norm();
  ASSERT_TRUE(simulator.advance(60.0));
  EXPECT_NEAR(simulator.vessel().velocity.x(), 3.0, 0.1);
  EXPECT_NEAR(simulator.endForces().vessel.norm(), start, 0.05 * start);
  double least = start, deepest = 0.0;
  for (double t = 60.0; t < 700.0; t += 1.0)
  {
    ASSERT_TRUE(simulator.advance(t)) << t;
    least = std::min(least, simulator.endForces().vessel.norm());
    deepest = std::min(deepest, simulator.vehicle().position.z());
  }
  EXPECT_NEAR(std::abs(yaw(simulator.vessel().orientation)), M_PI, 0.1) << "turned round";
  EXPECT_LT(least, 0.9 * start) << "tension falls in the turn";
  EXPECT_LT(deepest, simulator.vehicle().position.z() - 3.0) << "and the body sinks";
  EXPECT_NEAR(simulator.endForces().vessel.norm(), start, 0.05 * start);
}

TEST(Scenarios, HeaveInWavesSwingsTheTensionAboutTheWeight)
{
  ScenarioFile scenario("heave_in_waves");
  Simulator simulator(scenario.config, scenario.simulation);
  const double weight = 9.81 * (1500.0 - 1025.0 * 0.25);
  double least = INFINITY, most = 0.0, heave = 0.0;
  for (double t = 0.0; t < 120.0; t += 0.1)
  {
    ASSERT_TRUE(simulator.advance(t)) << t;
    if (t < 30.0)
      continue;
    const double tension = simulator.endForces().vehicle.norm();
    least = std::min(least, tension);
    most = std::max(most, tension);
    heave = std::max(heave, simulator.vessel().position.z());
  }
  EXPECT_GT(heave, 0.3);
  EXPECT_LT(heave, 2.5);
  EXPECT_LT(least, 0.97 * weight);
  EXPECT_GT(most, 1.03 * weight);
}

TEST(Scenarios, TheRovDrawsItsTetherRoundThePile)
{
  ScenarioFile scenario("rov_and_pile");
  Simulator simulator(scenario.config, scenario.simulation);
  core::ContactSummary contact;
  contact.obstacles.resize(1);
  double pressed = 0.0, on_floor = 0.0;
  for (double t = 0.0; t < 180.0; t += 0.5)
  {
    ASSERT_TRUE(simulator.advance(t)) << t;
    core::summarizeContact(core::DeployedCable(simulator.model(), simulator.state().deployment), simulator.state(),
                           contact);
    pressed = std::max(pressed, contact.obstacles[0].force.norm());
    on_floor = std::max(on_floor, contact.seabed_length);
    const double speed = simulator.vehicle().velocity.norm();
    ASSERT_LT(speed, 2.0) << t;
  }
  EXPECT_GT(pressed, 5.0);
  EXPECT_GT(on_floor, 1.0);
  EXPECT_LT((simulator.vehicle().position - core::Vector3(28, 18, -54)).norm(), 3.0);
}

TEST(Scenarios, PayOutAndRecoveryEndWhereTheyBegan)
{
  ScenarioFile scenario("payout_and_recovery");
  Simulator simulator(scenario.config, scenario.simulation);
  const double start = simulator.endForces().vessel.norm();
  ASSERT_TRUE(simulator.advance(70.0));
  EXPECT_NEAR(simulator.payout().rate, 1.0, 1e-6);
  ASSERT_TRUE(simulator.advance(170.0));
  EXPECT_NEAR(simulator.payout().length, 300.0, 1e-3);
  EXPECT_NEAR(core::DeployedCable(simulator.model(), simulator.state().deployment).mass(), 0.6 * 300.0, 1e-3);
  ASSERT_TRUE(simulator.advance(500.0));
  EXPECT_NEAR(simulator.payout().length, 200.0, 1e-3);
  EXPECT_NEAR(simulator.endForces().vessel.norm(), start, 0.05 * start);
}

TEST(Simulator, ListsEveryProblem)
{
  ScenarioFile scenario("tow_and_turn");
  scenario.config.tether.diameter = -1.0;
  scenario.simulation.vessel.ship.beam = 0.1;
  scenario.simulation.vehicle_sensor.dropout = 2.0;
  try
  {
    Simulator simulator(scenario.config, scenario.simulation);
    FAIL() << "it was accepted";
  }
  catch (const std::invalid_argument& error)
  {
    for (const char* name : {"tether.diameter", "simulation.vessel.beam", "simulation.vehicle.sensor.dropout"})
      EXPECT_NE(std::string(error.what()).find(name), std::string::npos) << name;
  }
}

TEST(Sensor, HasTheNoiseRateAndLossesOfItsPlan)
{
  SensorModel plan;
  plan.rate = 10.0;
  plan.position_stddev = 0.3;
  plan.velocity_stddev = 0.05;
  plan.dropout = 0.2;
  plan.latency = 0.5;
  plan.gap_from = 100.0;
  plan.gap_to = 200.0;
  Sensor sensor(plan, 5), twin(plan, 5);
  monitor::BodyState truth;
  truth.position = {1.0, 2.0, 3.0};
  double sum = 0.0;
  int count = 0;
  for (int k = 0; k < 40000; ++k)
  {
    const double t = 0.025 * k;
    const auto arrived = sensor.sample(t, truth);
    const auto also = twin.sample(t, truth);
    ASSERT_EQ(arrived.size(), also.size());
    for (std::size_t i = 0; i < arrived.size(); ++i)
    {
      EXPECT_EQ(arrived[i].body.position, also[i].body.position) << "same seed, same noise";
      EXPECT_GE(t, arrived[i].time + 0.5 - 1e-6);
      EXPECT_FALSE(arrived[i].time >= 100.0 && arrived[i].time < 200.0);
      sum += (arrived[i].body.position - truth.position).squaredNorm();
      ++count;
    }
  }
  // 900 s at 10 Hz, one in five lost: 7200 of them, each a chance of its own (stddev 38).
  EXPECT_NEAR(count, 7200, 200);
  EXPECT_NEAR(std::sqrt(sum / (3.0 * count)), 0.3, 0.01);
}

}  // namespace tether_monitor::simulation
