#include "tether_monitor/replay/steady_state_run.h"

#include <gtest/gtest.h>

#include "support/navigation_fixture.h"

namespace tether_monitor::replay
{
using core::Vector3;

TEST(SteadyStateRun, OfAnObservedVehicleIsFound)
{
  const monitor::Config config = monitor::observedConfig();
  const SteadyState steady = findSteadyState(config, {0.0, 0.0, 1.0}, {20.0, 0.0, -96.0}, Vector3::Zero(), 3);
  ASSERT_TRUE(steady.report.converged()) << core::describe(steady.report.status);
  EXPECT_GT(steady.report.iterations, 0);
  ASSERT_TRUE(steady.estimate.has_stations);
  EXPECT_LT((steady.estimate.stations.position.back() - Vector3(20.0, 0.0, -96.0)).norm(), 1e-9) << "held";
  EXPECT_EQ(steady.modes.size(), 3u);
  EXPECT_EQ(steady.node_s.back(), config.tether.length);
}

TEST(SteadyStateRun, OfHeldEndsIsExactlyThere)
{
  const SteadyState steady =
      findSteadyState(monitor::testConfig(), {0.0, 0.0, 1.0}, {60.0, 0.0, -70.0}, {0.5, 0.0, 0.0});
  ASSERT_TRUE(steady.estimate.has_stations);
  EXPECT_LT((steady.estimate.stations.position.back() - Vector3(60.0, 0.0, -70.0)).norm(), 1e-9);
  EXPECT_TRUE(steady.modes.empty());
}

TEST(SteadyStateRun, ATetherThatIsTooShortHasNone)
{
  const SteadyState steady =
      findSteadyState(monitor::testConfig(), {0.0, 0.0, 1.0}, {6.0e4, 0.0, -70.0}, Vector3::Zero());
  EXPECT_EQ(steady.estimate.status, monitor::Status::INVALID);
}

}  // namespace tether_monitor::replay
