#include "tether_monitor/monitor/estimator/live_settings.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "support/navigation_fixture.h"
#include "tether_monitor/monitor/alarms/alarm_quantities.h"
#include "tether_monitor/monitor/config/config_fingerprint.h"

namespace tether_monitor::monitor
{
namespace
{
double* find(Config& config, const std::string& key)
{
  for (const LiveSetting& setting : liveSettings(config))
    if (setting.key == key)
      return setting.value;
  return nullptr;
}

double meanOf(const TetherEstimator& estimator, Parameter parameter)
{
  return estimator.vehicle().ensemble()->filter().parameters().row(parameter).mean();
}

double spreadOf(const TetherEstimator& estimator, Parameter parameter)
{
  const auto row = estimator.vehicle().ensemble()->filter().parameters().row(parameter);
  return std::sqrt((row.array() - row.mean()).square().mean());
}
}  // namespace

TEST(LiveSettings, AreNumbersOfTheConfigurationWithinTheirBounds)
{
  Config config = observedConfig();
  std::set<std::string> keys;
  for (const LiveSetting& setting : liveSettings(config))
  {
    EXPECT_TRUE(keys.insert(setting.key).second) << setting.key;
    EXPECT_GE(*setting.value, setting.least) << setting.key;
    EXPECT_LE(*setting.value, setting.most) << setting.key;
    EXPECT_FALSE(setting.meaning.empty());
  }
  EXPECT_EQ(find(config, "tether.drag_normal"), &config.tether.drag_normal);
  EXPECT_EQ(find(config, "monitor.alarms.slack.limit"), nullptr) << "it has none to change";
  EXPECT_TRUE(validate(config).empty());
}

// A node that is started again has the parameter server's numbers, and goes on from the state that was kept.
TEST(LiveSettings, LookingAtThemMakesNoOtherConfiguration)
{
  Config config = observedConfig();
  for (const AlarmQuantity& quantity : alarmQuantities())
    alarmConfig(config, quantity.name);  // as the loader does
  config.navigation.force_stddev.reset();
  const std::uint64_t by_default = fingerprint(config);
  liveSettings(config);
  EXPECT_EQ(fingerprint(config), by_default);
  *find(config, "vehicle.force_stddev") *= 1.5;
  EXPECT_NE(fingerprint(config), by_default);
}

TEST(LiveSettings, NothingElseCanBeChanged)
{
  const Config config = observedConfig();
  Config other = config;
  *find(other, "tether.drag_normal") *= 1.2;
  *find(other, "monitor.alarms.over_tension.on_delay") = 3.0;
  EXPECT_TRUE(differInLiveSettingsOnly(config, other));
  other.tether.mass_per_length *= 1.01;
  EXPECT_FALSE(differInLiveSettingsOnly(config, other));

  TetherEstimator estimator(config);
  EXPECT_THAT(estimator.reconfigure(other), testing::ElementsAre(testing::HasSubstr("only drag")));
  other = config;
  other.tether.drag_normal = -1.0;
  EXPECT_THAT(estimator.reconfigure(other), testing::ElementsAre(testing::HasSubstr("tether.drag_normal")));
  EXPECT_EQ(estimator.config().tether.drag_normal, config.tether.drag_normal);
}

TEST(LiveSettings, TheTetherGoesOnAndWhatIsToldAnewIsForgotten)
{
  NavigationFixture sea;
  ASSERT_EQ(sea.run(60.0).status, Status::OK);
  const TetherEstimate before = sea.estimator.estimate();
  const double current = meanOf(sea.estimator, CURRENT_X);
  Config config = sea.estimator.config();
  config.tether.drag_normal *= 1.1;
  config.uncertainty.drag_normal = 0.05;
  alarmConfig(config, "over_tension").timing.on_delay = 7.0;
  ASSERT_THAT(sea.estimator.reconfigure(config), testing::IsEmpty());
  EXPECT_EQ(sea.estimator.estimate().vessel_tension, before.vessel_tension);
  EXPECT_EQ(sea.estimator.config().tether.drag_normal, config.tether.drag_normal);
  EXPECT_NEAR(meanOf(sea.estimator, DRAG_NORMAL), 0.0, 1e-9);
  EXPECT_NEAR(spreadOf(sea.estimator, DRAG_NORMAL), 0.05, 0.01);
  EXPECT_EQ(meanOf(sea.estimator, CURRENT_X), current) << "of the current nothing new was told";

  const TetherEstimate after = sea.run(0.05);
  EXPECT_EQ(after.status, Status::OK);
  EXPECT_NEAR(after.vessel_tension, before.vessel_tension, 0.1 * before.vessel_tension);
  EXPECT_NE(sea.run(30.0).status, Status::INVALID);
}

TEST(LiveSettings, SameNumbersChangeNothing)
{
  NavigationFixture a;
  a.run(40.0);
  NavigationFixture b = a;
  ASSERT_THAT(b.estimator.reconfigure(b.estimator.config()), testing::IsEmpty());
  EXPECT_EQ(a.run(10.0).vessel_tension, b.run(10.0).vessel_tension);
}
}  // namespace tether_monitor::monitor
