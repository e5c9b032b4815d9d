#include "tether_monitor/monitor/estimator/tether_estimator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"
#include "tether_monitor/monitor/alarms/alarm_quantities.h"

namespace tether_monitor::monitor
{
TEST(Estimator, SettlesThenRuns)
{
  EstimatorFixture feeder;
  feeder.estimator.tick(feeder.t);
  EXPECT_EQ(feeder.estimator.estimate().reason, Reason::NO_INPUT);
  EXPECT_TRUE(feeder.estimator.overTension()) << "before the first estimate";
  feeder.run(0.05);
  EXPECT_EQ(feeder.estimator.estimate().reason, Reason::SETTLING);
  EXPECT_TRUE(feeder.estimator.overTension()) << "while settling";
  const TetherEstimate& e = feeder.run(1.0);
  EXPECT_EQ(e.status, Status::OK) << describe(e.reason);
  EXPECT_FALSE(feeder.estimator.overTension());
  EXPECT_NEAR(e.time, feeder.t, 1e-12);
  EXPECT_NEAR(e.stations.position.front().z(), 1.0, 1e-9);
  EXPECT_NEAR((e.stations.position.back() - feeder.vehicle).norm(), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(e.stations.s.back(), 100.0);
  EXPECT_DOUBLE_EQ(e.length, 100.0);
  EXPECT_GT(e.vessel_tension, e.vehicle_tension);
  EXPECT_NEAR(e.working_utilisation, e.max_tension / 1000.0, 1e-12);
  EXPECT_GT(e.stations.stretched_length, 99.99);
  // The tether leaves the vessel downwards, and forces point along it.
  EXPECT_GT(e.vessel_end_angle, 0.5);
  EXPECT_LT(e.stations.ends.vessel.z(), 0.0);
  EXPECT_GT(e.stations.ends.vessel.x(), 0.0);
}

TEST(Estimator, FarAwayTheNumbersAreTheSame)
{
  EstimatorFixture near, far;
  const core::Vector3 away(500000.0, 4.0e6, 0.0);
  far.vessel += away;
  far.vehicle += away;
  far.vehicle_velocity = near.vehicle_velocity = {0.2, 0.1, 0.0};
  near.run(3.0);
  far.run(3.0);
  ASSERT_EQ(far.estimator.estimate().status, Status::OK);
  EXPECT_NEAR(far.estimator.estimate().vessel_tension, near.estimator.estimate().vessel_tension, 1e-3);
  EXPECT_NEAR(
      (far.estimator.estimate().stations.position[7] - near.estimator.estimate().stations.position[7] - away)
          .norm(),
      0.0, 1e-4);
}

TEST(Estimator, AStaleVehicleDegradesThenInvalidatesAndComesBack)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  feeder.vehicle_alive = false;
  const TetherEstimate& e = feeder.run(2.0);
  EXPECT_EQ(e.status, Status::DEGRADED);
  EXPECT_EQ(e.reason, Reason::VEHICLE_STALE);
  EXPECT_TRUE(std::isfinite(e.max_tension));
  feeder.run(3.2);
  EXPECT_EQ(e.status, Status::INVALID);
  EXPECT_EQ(e.reason, Reason::VEHICLE_STALE);
  EXPECT_TRUE(std::isnan(e.max_tension)) << "an invalid estimate must not carry a usable number";
  EXPECT_FALSE(e.has_stations);
  EXPECT_TRUE(feeder.estimator.overTension());
  EXPECT_GT(e.vehicle_age, 5.0);
  feeder.vehicle_alive = true;
  feeder.run(0.3);
  EXPECT_EQ(e.status, Status::OK);
  EXPECT_FALSE(feeder.estimator.overTension());
}

TEST(Estimator, AStaleVesselIsNamed)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  feeder.vessel_alive = false;
  EXPECT_EQ(feeder.run(2.0).reason, Reason::VESSEL_STALE);
}

TEST(Estimator, TimeRunningBackwardsStartsAnew)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  feeder.t -= 50.0;
  const TetherEstimate& e = feeder.estimator.tick(feeder.t);
  EXPECT_EQ(e.status, Status::INVALID);
  EXPECT_EQ(e.reason, Reason::CLOCK_JUMP);
  EXPECT_TRUE(feeder.estimator.overTension());
  EXPECT_EQ(feeder.run(0.5).status, Status::OK);
}

TEST(Estimator, TimeLeapingAheadIsSaid)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  feeder.t += 60.0;
  EXPECT_EQ(feeder.estimator.tick(feeder.t).reason, Reason::CLOCK_JUMP);
  EXPECT_EQ(feeder.run(1.0).status, Status::OK);
}

TEST(Estimator, ARefusedInputIsSaidForAWhile)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK) << "precondition";
  feeder.estimator.noteRejectedInput(feeder.t);
  EXPECT_EQ(feeder.run(0.5).reason, Reason::REJECTED_INPUT);
  EXPECT_EQ(feeder.run(1.0).status, Status::OK);
}

TEST(Estimator, PullingTheTetherTautRaisesTheAlarmAndLatches)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(1.0).status, Status::OK) << "precondition";
  feeder.vehicle_velocity = {0.8, 0.0, -0.5};
  bool raised = false;
  for (int i = 0; i < 300 && !raised; ++i)
  {
    feeder.run(0.05);
    raised = feeder.estimator.overTension();
  }
  ASSERT_TRUE(raised);
  EXPECT_GT(feeder.estimator.estimate().working_utilisation, 1.0);
  feeder.vehicle_velocity = {-0.8, 0.0, 0.5};
  feeder.run(8.0);
  EXPECT_LT(feeder.estimator.estimate().working_utilisation, 0.9);
  EXPECT_TRUE(feeder.estimator.overTension()) << "latched";
  EXPECT_GT(feeder.estimator.acknowledge(), 0);
  EXPECT_FALSE(feeder.estimator.overTension());
}

TEST(Estimator, ImpossibleEndsEndInAStatus)
{
  EstimatorFixture feeder;
  feeder.vehicle = {4.0e5, 0.0, -70.0};  // 400 km from the vessel on 100 m of tether
  feeder.run(3.0);
  EXPECT_NE(feeder.estimator.estimate().status, Status::OK);
}

TEST(Estimator, AStartThatFailsLeavesNoTrace)
{
  EstimatorFixture feeder;
  ASSERT_EQ(feeder.run(2.0).status, Status::OK);
  const core::CableModel model = feeder.estimator.simulation().model;
  const core::NodeField q = feeder.estimator.simulation().state.q;
  EndTargets far;
  far.vessel.position = {500.0, 0.0, 1.0};
  far.vehicle.position.setConstant(std::nan(""));
  far.payout = core::PayoutState{90.0, 0.0, 0.0};
  EXPECT_EQ(feeder.estimator.begin(feeder.t, far).reason, Reason::NOT_CONVERGED);
  EXPECT_EQ(feeder.estimator.phase(), Phase::STARTING);
  EXPECT_TRUE(feeder.estimator.simulation().model.isSame(model)) << "origin and obstacles";
  EXPECT_EQ(feeder.estimator.simulation().length(), 100.0);
  EXPECT_EQ(feeder.estimator.simulation().state.q, q);
}

TEST(Estimator, GoesThroughItsPhases)
{
  EstimatorFixture feeder;
  EXPECT_EQ(feeder.estimator.phase(), Phase::IDLE);
  feeder.estimator.tick(feeder.t);
  EXPECT_EQ(feeder.estimator.phase(), Phase::WAITING);
  feeder.run(0.05);
  EXPECT_EQ(feeder.estimator.phase(), Phase::STARTING);
  feeder.run(1.0);
  EXPECT_EQ(feeder.estimator.phase(), Phase::RUNNING);
  feeder.t += 100.0;
  feeder.run(0.05);
  EXPECT_EQ(feeder.estimator.phase(), Phase::WAITING) << "the clock has leapt";
  feeder.run(1.0);
  EXPECT_EQ(feeder.estimator.phase(), Phase::RUNNING);
  feeder.estimator.reset();
  EXPECT_EQ(feeder.estimator.phase(), Phase::IDLE);
}

TEST(Estimator, AMessageIsAcceptedAsAWholeOrNotAtAllInEveryMode)
{
  for (const VehicleMode mode : {VehicleMode::TRACKED, VehicleMode::FREE, VehicleMode::OBSERVED})
  {
    Config config = testConfig();
    config.vehicle_mode = mode;
    config.vehicle_body = smallVehicle();
    TetherEstimator estimator(config);
    const PoseMeasurement pose{1.0, core::Vector3(0.0, 0.0, 1.0)};
    const TwistMeasurement rates{1.0, core::Vector3(NAN, 0.0, 0.0)};
    EXPECT_EQ(estimator.addVessel(pose, rates), Rejection::NOT_FINITE);
    EXPECT_EQ(estimator.addVehicle(pose, rates), Rejection::NOT_FINITE);
    EXPECT_FALSE(estimator.vessel().track().hasPose());
    EXPECT_FALSE(estimator.vehicle().track().hasPose());
    EXPECT_TRUE(std::isinf(estimator.vessel().age(2.0)));
  }
}

TEST(Estimator, ACopyGoesOnAsTheOriginal)
{
  EstimatorFixture feeder;
  feeder.vehicle_velocity = {0.1, 0.2, 0.0};
  ASSERT_EQ(feeder.run(3.0).status, Status::OK) << "precondition";
  EstimatorFixture copy = feeder;
  feeder.run(3.0);
  copy.run(3.0);
  EXPECT_EQ(feeder.estimator.estimate().vessel_tension, copy.estimator.estimate().vessel_tension);
  EXPECT_EQ(feeder.estimator.simulation().state.q[5], copy.estimator.simulation().state.q[5]);
}

TEST(Estimator, ACurrentChangesTheForces)
{
  EstimatorFixture feeder;
  const double before = feeder.run(1.0).vessel_tension;
  feeder.estimator.setCurrent(core::CurrentProfile(core::Vector3(0.0, 1.0, 0.0)));
  EXPECT_GT(std::abs(feeder.run(10.0).vessel_tension - before), 0.1 * before);
}

namespace
{
// Those of the alarms included.
std::vector<std::string> faultsOf(const Config& config)
{
  std::vector<std::string> all = validate(config);
  const std::vector<std::string> of_alarms = validateAlarms(config);
  all.insert(all.end(), of_alarms.begin(), of_alarms.end());
  return all;
}
}  // namespace

struct Fault
{
  const char* name;
  void (*make)(Config&);
};
class ConfigRefuses : public ::testing::TestWithParam<Fault>
{
};
TEST_P(ConfigRefuses, AndNamesTheKey)
{
  Config config = testConfig();
  ASSERT_TRUE(faultsOf(config).empty()) << "precondition";
  GetParam().make(config);
  const std::vector<std::string> found = faultsOf(config);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].find(GetParam().name), 0u) << found[0];
  EXPECT_THROW(TetherEstimator{config}, std::invalid_argument);
}
INSTANTIATE_TEST_SUITE_P(
    Bounds, ConfigRefuses,
    ::testing::Values(
        Fault{"monitor.rate", [](Config& c) { c.rate = 0.0; }},
        Fault{"monitor.pose_timeout", [](Config& c) { c.pose_timeout = -1.0; }},
        Fault{"monitor.invalid_timeout", [](Config& c) { c.invalid_timeout = 0.5; }},
        Fault{"winch.core_diameter",
              [](Config& c)
              {
                c.winch = core::WinchProperties{0.2, 0.6, 20};
                c.tether.min_bend_radius = 0.4;
              }},
        Fault{"tether.length",
              [](Config& c) {
                c.winch = core::WinchProperties{0.2, 0.05, 3};
              }},
        Fault{"tether.drag_amplification", [](Config& c) { c.drag_amplification = 0.5; }},
        Fault{"solver.courant", [](Config& c) { c.solver.courant = 0.0; }},
        Fault{"solver.corrections", [](Config& c) { c.solver.corrections = -1; }},
        Fault{"environment.seabed.depth",
              [](Config& c)
              {
                c.environment.seabed = core::Seabed();
                c.environment.seabed->depth = 0.0;
              }},
        Fault{"solver.step", [](Config& c) { c.solver.step = NAN; }},
        Fault{"vessel.attachment", [](Config& c) { c.vessel.attachment.x() = NAN; }},
        Fault{"vehicle.attachment", [](Config& c) { c.vehicle.attachment.x() = INFINITY; }},
        Fault{"world_frame", [](Config& c) { c.world_frame = ""; }},
        Fault{"monitor.alarms.over_tension.warning",
              [](Config& c) { alarmConfig(c, "over_tension").warning = 1.5; }},
        Fault{"monitor.alarms.breaking.limit", [](Config& c) { alarmConfig(c, "breaking").limit = NAN; }},
        Fault{"monitor.alarms.slack.on_delay", [](Config& c) { alarmConfig(c, "slack").timing.on_delay = -1.0; }},
        Fault{"monitor.alarms.stale_input.off_delay",
              [](Config& c) { alarmConfig(c, "stale_input").timing.off_delay = NAN; }},
        Fault{"monitor.alarms.bend_radius.deadband",
              [](Config& c) { alarmConfig(c, "bend_radius").timing.deadband = -1.0; }}));

}  // namespace tether_monitor::monitor
