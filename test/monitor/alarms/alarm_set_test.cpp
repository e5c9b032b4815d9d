#include "tether_monitor/monitor/alarms/alarm_set.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
// All alarms at once, without delays.
Config watchfulConfig()
{
  Config config = testConfig();
  for (const AlarmQuantity& quantity : alarmQuantities())
    alarmConfig(config, quantity.name) = {std::nullopt, 10.0, {}};
  return config;
}

const Alarm& alarmOf(const AlarmSet& set, const std::string& name)
{
  return *std::find_if(set.alarms().begin(), set.alarms().end(),
                       [&](const Alarm& alarm) { return alarm.definition().name == name; });
}

TEST(AlarmSet, HasALimitAlarmAndAWarningWhereTheyAreWanted)
{
  Config config = testConfig();
  const AlarmSet defaults(config);
  const auto has = [](const AlarmSet& set, const std::string& name)
  {
    return std::any_of(set.alarms().begin(), set.alarms().end(),
                       [&](const Alarm& alarm) { return alarm.definition().name == name; });
  };
  EXPECT_TRUE(has(defaults, "over_tension"));
  EXPECT_TRUE(has(defaults, "over_tension_warning"));
  EXPECT_FALSE(has(defaults, "slack"));
  alarmConfig(config, "slack").warning = 5.0;
  EXPECT_TRUE(has(AlarmSet(config), "slack_warning"));
  EXPECT_FALSE(has(AlarmSet(config), "slack"));
}

// A number of the estimate or of the inputs that an alarm watches.
struct Watched
{
  std::string name;
  double TetherEstimate::*of_estimate = nullptr;
  double AlarmInputs::*of_inputs = nullptr;
};

const std::vector<Watched> WATCHED{{"over_tension", &TetherEstimate::working_utilisation},
                                   {"breaking", &TetherEstimate::breaking_utilisation},
                                   {"slack", &TetherEstimate::min_tension},
                                   {"snap", nullptr, &AlarmInputs::tension_rate},
                                   {"bend_radius", &TetherEstimate::governing_bend_radius},
                                   {"seabed_contact", &TetherEstimate::seabed_contact_length},
                                   {"obstacle_contact", nullptr, &AlarmInputs::obstacle_force},
                                   {"obstacle_clearance", nullptr, &AlarmInputs::clearance},
                                   {"lay_back", nullptr, &AlarmInputs::lay_back},
                                   {"scope", nullptr, &AlarmInputs::scope},
                                   {"turns", nullptr, &AlarmInputs::turns},
                                   {"resonance", nullptr, &AlarmInputs::resonance},
                                   {"lock_in", nullptr, &AlarmInputs::lock_in},
                                   {"forecast", nullptr, &AlarmInputs::forecast_probability},
                                   {"mismatch", nullptr, &AlarmInputs::mismatch},
                                   {"stale_input", &TetherEstimate::vessel_age},
                                   {"deadline", nullptr, &AlarmInputs::missed_cycles}};

TEST(AlarmSet, EachWatchesItsOwnNumber)
{
  EXPECT_EQ(WATCHED.size() + 4, alarmQuantities().size()) << "a new alarm has its line here, or a test of its own";
  for (const Watched& watched : WATCHED)
  {
    AlarmSet set(watchfulConfig());
    TetherEstimate e;
    AlarmInputs inputs;
    e.vehicle_overdue = 0.0;
    double& number = watched.of_estimate ? e.*watched.of_estimate : inputs.*watched.of_inputs;
    const bool is_low_bad = alarmOf(set, watched.name).definition().side == Side::BELOW;
    number = 10.0;
    set.update(e, inputs);
    EXPECT_FALSE(alarmOf(set, watched.name).isAnnunciated()) << watched.name << " at its limit";
    number = is_low_bad ? 9.9 : 10.1;
    EXPECT_TRUE(set.update(e, inputs)) << watched.name;
    for (const Alarm& alarm : set.alarms())
      EXPECT_EQ(alarm.isAnnunciated(), alarm.definition().name == watched.name) << alarm.definition().name;
  }
}

TEST(AlarmSet, TurnsCountEitherWayRound)
{
  AlarmSet set(testConfig());
  AlarmInputs inputs;
  inputs.turns = -5.5;
  for (const double t : {0.0, 1.0})
  {
    TetherEstimate e;
    e.time = t;
    set.update(e, inputs);
  }
  EXPECT_TRUE(alarmOf(set, "turns").isActive());
}

TEST(AlarmSet, TheTouchdownHasAZone)
{
  Config config = testConfig();
  alarmConfig(config, "touchdown_near") = {std::nullopt, 20.0, {}};
  alarmConfig(config, "touchdown_far") = {std::nullopt, 50.0, {}};
  for (const auto& [distance, near, far] :
       {std::tuple(10.0, true, false), {30.0, false, false}, {60.0, false, true}})
  {
    AlarmSet set(config);
    AlarmInputs inputs;
    inputs.touchdown_distance = distance;
    set.update(TetherEstimate(), inputs);
    EXPECT_EQ(alarmOf(set, "touchdown_near").isActive(), near) << distance;
    EXPECT_EQ(alarmOf(set, "touchdown_far").isActive(), far) << distance;
  }
}

TEST(AlarmSet, SaysThatAnInputCannotBeTrueAndThatTheSolverFailed)
{
  Config config = testConfig();
  alarmConfig(config, "solver_fault").timing.on_delay = 0.0;
  for (const Reason reason : {Reason::NONE, Reason::IMPLAUSIBLE, Reason::DISAGREEMENT, Reason::NOT_CONVERGED,
                              Reason::OUT_OF_RANGE, Reason::VESSEL_STALE})
  {
    AlarmSet set(config);
    TetherEstimate e;
    e.status = reason == Reason::NONE ? Status::OK : Status::INVALID;
    e.reason = reason;
    e.reasons.add(reason);
    set.update(e, AlarmInputs());
    EXPECT_EQ(alarmOf(set, "implausible_input").isActive(),
              reason == Reason::IMPLAUSIBLE || reason == Reason::DISAGREEMENT)
        << describe(reason);
    EXPECT_EQ(alarmOf(set, "solver_fault").isActive(),
              reason == Reason::NOT_CONVERGED || reason == Reason::OUT_OF_RANGE)
        << describe(reason);
  }
}

// An update of watchfulConfig() with two numbers.
void feed(AlarmSet& set, double t, double utilisation, double lay_back)
{
  TetherEstimate e;
  e.time = t;
  e.working_utilisation = utilisation;
  AlarmInputs inputs;
  inputs.lay_back = lay_back;
  set.update(e, inputs);
}

TEST(AlarmSet, KnowsWhichCameFirstUntilAllAreGone)
{
  AlarmSet set(watchfulConfig());
  const int lay_back = static_cast<int>(&alarmOf(set, "lay_back") - set.alarms().data());
  EXPECT_EQ(set.firstOut(), -1);
  feed(set, 0.0, 1.0, 11.0);
  EXPECT_EQ(set.firstOut(), lay_back);
  feed(set, 1.0, 11.0, 11.0);
  EXPECT_EQ(set.firstOut(), lay_back);
  feed(set, 2.0, 11.0, 1.0);
  EXPECT_EQ(set.firstOut(), lay_back) << "it is gone, but it came first";
  feed(set, 3.0, 1.0, 1.0);
  EXPECT_EQ(set.firstOut(), -1);
}

TEST(AlarmSet, LogsEveryChangeWithPeakAndDuration)
{
  AlarmSet set(watchfulConfig());
  feed(set, 0.0, 11.0, 1.0);
  feed(set, 1.0, 15.0, 1.0);
  feed(set, 3.0, 1.0, 1.0);
  feed(set, 4.0, 1.0, 1.0);
  ASSERT_EQ(set.log().last(), 2);
  const AlarmEvent &came = set.log().events()[0], &went = set.log().events()[1];
  EXPECT_EQ(came.to, AlarmState::UNACKNOWLEDGED);
  EXPECT_TRUE(came.first_out);
  EXPECT_EQ(went.from, AlarmState::UNACKNOWLEDGED);
  EXPECT_EQ(went.to, AlarmState::NORMAL);
  EXPECT_DOUBLE_EQ(went.peak, 15.0);
  EXPECT_DOUBLE_EQ(went.duration, 3.0);
  EXPECT_DOUBLE_EQ(went.value, 1.0);
}

TEST(AlarmSet, AnOperatorsActionIsDoneOrItSaysWhyNot)
{
  AlarmSet set(watchfulConfig());
  EXPECT_EQ(set.act("over_tensions", AlarmAction::ACKNOWLEDGE, 0.0), "there is no alarm 'over_tensions'");
  EXPECT_EQ(set.act("over_tension", AlarmAction::ACKNOWLEDGE, 0.0), "'over_tension' is normal");
  EXPECT_NE(set.act("over_tension", AlarmAction::SHELVE, 0.0, 0.0), "");
  EXPECT_EQ(set.act("over_tension", AlarmAction::SHELVE, 0.0, 60.0), "");
  EXPECT_EQ(set.log().events().back().to, AlarmState::SHELVED);
  feed(set, 1.0, 11.0, 1.0);
  EXPECT_EQ(set.firstOut(), -1) << "it is not announced";
  EXPECT_TRUE(set.overTension()) << "but a control loop is told";
  feed(set, 60.0, 11.0, 1.0);
  EXPECT_EQ(alarmOf(set, "over_tension").state(), AlarmState::UNACKNOWLEDGED);
}

TEST(AlarmSet, KeepsTheOverTensionFlagUntilItIsAcknowledged)
{
  Config config = watchfulConfig();
  alarmConfig(config, "over_tension").timing.latch = true;
  AlarmSet set(config);
  TetherEstimate e;
  e.working_utilisation = 11.0;
  set.update(e, AlarmInputs());
  EXPECT_TRUE(set.overTension());
  e.time = 1.0;
  e.working_utilisation = 1.0;
  set.update(e, AlarmInputs());
  EXPECT_TRUE(set.overTension());
  EXPECT_EQ(set.acknowledge(2.0), 1);
  EXPECT_FALSE(set.overTension());
}

}  // namespace tether_monitor::monitor
