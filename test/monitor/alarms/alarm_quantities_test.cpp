#include "tether_monitor/monitor/alarms/alarm_quantities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
TEST(AlarmQuantities, HaveNamesOfTheirOwn)
{
  std::set<std::string> names;
  for (const AlarmQuantity& quantity : alarmQuantities())
    EXPECT_TRUE(names.insert(quantity.name).second) << quantity.name;
  EXPECT_EQ(alarmQuantities().front().name, std::string(OVER_TENSION));
}

TEST(AlarmQuantities, SayWhatTheyAreAndWhatToDo)
{
  for (const AlarmQuantity& quantity : alarmQuantities())
  {
    EXPECT_FALSE(std::string(quantity.unit).empty()) << quantity.name;
    EXPECT_FALSE(std::string(quantity.meaning).empty()) << quantity.name;
    const std::string advice = quantity.advice;
    ASSERT_GT(advice.size(), 10u) << quantity.name;
    EXPECT_EQ(advice.back(), '.') << quantity.name;
  }
}

TEST(AlarmQuantities, AreUnknownInAnEmptyEstimate)
{
  for (const AlarmQuantity& quantity : alarmQuantities())
    EXPECT_TRUE(std::isnan(quantity.value(TetherEstimate(), AlarmInputs()).value)) << quantity.name;
}

TEST(AlarmQuantities, DeriveLimitsThatAreNotGiven)
{
  Config config = testConfig();
  config.tether.min_bend_radius = 0.4;
  config.pose_timeout = 2.0;
  for (const AlarmQuantity& quantity : alarmQuantities())
  {
    const std::string name = quantity.name;
    if (name == "bend_radius")
    {
      EXPECT_EQ(alarmConfig(config, quantity).limit, 0.4);
    }
    if (name == "stale_input")
    {
      EXPECT_EQ(alarmConfig(config, quantity).limit, 2.0);
    }
  }
  alarmConfig(config, "stale_input").limit = 7.0;
  EXPECT_EQ(config.alarms.at("stale_input").limit, 7.0);
  EXPECT_THROW(alarmConfig(config, "stale_inputs"), std::out_of_range);
}

TEST(AlarmQuantities, EveryBoundOfEveryAlarmIsChecked)
{
  for (const AlarmQuantity& quantity : alarmQuantities())
  {
    const double bad_warning = quantity.side == Side::ABOVE ? 2.0 : 1.0;
    const std::vector<std::pair<const char*, std::function<void(AlarmConfig&)>>> faults{
        {"on_delay", [](AlarmConfig& a) { a.timing.on_delay = -1.0; }},
        {"off_delay", [](AlarmConfig& a) { a.timing.off_delay = NAN; }},
        {"deadband", [](AlarmConfig& a) { a.timing.deadband = -0.1; }},
        {"realarm", [](AlarmConfig& a) { a.timing.realarm = -1.0; }},
        {"chatter_hold", [](AlarmConfig& a) { a.timing.chatter_hold = INFINITY; }},
        {"limit", [](AlarmConfig& a) { a.limit = INFINITY; }},
        {"warning", [&](AlarmConfig& a)
         {
           a.limit = 1.5;
           a.warning = bad_warning;
         }}};
    for (const auto& [key, fault] : faults)
    {
      Config config = testConfig();
      EXPECT_TRUE(validateAlarms(config).empty());
      fault(alarmConfig(config, quantity.name));
      const std::vector<std::string> problems = validateAlarms(config);
      ASSERT_EQ(problems.size(), 1u) << quantity.name << " " << key;
      EXPECT_EQ(problems[0].find("monitor.alarms." + std::string(quantity.name) + "." + key), 0u) << problems[0];
    }
  }
}

}  // namespace tether_monitor::monitor
