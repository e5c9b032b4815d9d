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

TEST(AlarmSet, EachWatchesItsOwnNumber)
{
  const std::vector<std::pair<std::string, double TetherEstimate::*>> numbers{
      {"over_tension", &TetherEstimate::working_utilisation},
      {"breaking", &TetherEstimate::breaking_utilisation},
      {"slack", &TetherEstimate::min_tension},
      {"bend_radius", &TetherEstimate::governing_bend_radius},
      {"stale_input", &TetherEstimate::vessel_age}};
  EXPECT_EQ(numbers.size(), alarmQuantities().size()) << "a new alarm has its line here";
  for (const auto& [name, number] : numbers)
  {
    AlarmSet set(watchfulConfig());
    TetherEstimate e;
    e.vehicle_overdue = 0.0;
    const bool is_low_bad = alarmOf(set, name).definition().side == Side::BELOW;
    e.*number = 10.0;
    set.update(e);
    EXPECT_FALSE(alarmOf(set, name).isAnnunciated()) << name << " at its limit";
    e.*number = is_low_bad ? 9.9 : 10.1;
    EXPECT_TRUE(set.update(e)) << name;
    for (const Alarm& alarm : set.alarms())
      EXPECT_EQ(alarm.isAnnunciated(), alarm.definition().name == name) << alarm.definition().name;
  }
}

TEST(AlarmSet, KeepsTheOverTensionFlagUntilItIsAcknowledged)
{
  Config config = watchfulConfig();
  alarmConfig(config, "over_tension").timing.latch = true;
  AlarmSet set(config);
  TetherEstimate e;
  e.working_utilisation = 11.0;
  set.update(e);
  EXPECT_TRUE(set.overTension());
  e.time = 1.0;
  e.working_utilisation = 1.0;
  set.update(e);
  EXPECT_TRUE(set.overTension());
  EXPECT_EQ(set.acknowledge(2.0), 1);
  EXPECT_FALSE(set.overTension());
}

}  // namespace tether_monitor::monitor
