#include "tether_monitor/monitor/estimator/start_worker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <thread>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
// Vessel and vehicle on their ways, told at 20 Hz.
void feed(double t, TetherEstimator& estimator)
{
  estimator.addVessel(
      PoseMeasurement{t, core::Vector3(0.5 * t, 0.0, std::sin(t)), Eigen::Quaterniond::Identity()});
  estimator.addVehicle(
      PoseMeasurement{t, core::Vector3(60.0 + 0.5 * t, 0.0, -70.0), Eigen::Quaterniond::Identity()});
}

// Ticks as they come, from tick number `from` to `to`; waits a little in between, for the search has its own
// thread.
void run(int from, int to, TetherEstimator& estimator)
{
  for (int k = from; k < to; ++k)
  {
    feed(0.05 * k, estimator);
    estimator.tick(0.05 * k);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

// A mesh for such an accuracy takes some tenths of a second to choose.
Config slowConfig()
{
  Config config = testConfig();
  config.accuracy = 1e-5;
  return config;
}
}  // namespace

TEST(BackgroundStart, LeadsToTheMotionThatAStartAtOnceLeadsTo)
{
  TetherEstimator at_once(testConfig()), in_background(testConfig());
  in_background.setBackgroundStart(true);
  run(1, 400, at_once);
  run(1, 400, in_background);
  ASSERT_EQ(at_once.estimate().status, Status::OK);
  ASSERT_EQ(in_background.estimate().status, Status::OK);
  EXPECT_EQ(in_background.estimate().time, at_once.estimate().time);
  EXPECT_NEAR(in_background.estimate().vessel_tension, at_once.estimate().vessel_tension,
              1e-3 * at_once.estimate().vessel_tension)
      << "the sizes of its steps differ at first";
}

TEST(BackgroundStart, AnEasyStartTakesAFewTicks)
{
  TetherEstimator estimator(testConfig());
  estimator.setBackgroundStart(true);
  int k = 1;
  for (; k < 100 && !estimator.isRunning(); ++k)
  {
    run(k, k + 1, estimator);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_NE(estimator.estimate().reason, Reason::NOT_CONVERGED);
  }
  EXPECT_LT(k, 10);
}

TEST(BackgroundStart, TicksGoOnWhileItIsLookedFor)
{
  TetherEstimator estimator(slowConfig());
  estimator.setBackgroundStart(true);
  int settling = 0, k = 1;
  for (; k < 20000 && !estimator.isRunning(); ++k)
  {
    run(k, k + 1, estimator);
    settling += estimator.estimate().reason == Reason::SETTLING;
    ASSERT_TRUE(estimator.isRunning() || estimator.estimate().status == Status::INVALID);
  }
  ASSERT_TRUE(estimator.isRunning());
  EXPECT_GT(settling, 3);
  EXPECT_NEAR(estimator.simulation().state.time, 0.05 * (k - 1), 1e-9) << "it has caught up";
}

TEST(BackgroundStart, AResetOrACopyOfItsEstimatorDoesNotWait)
{
  TetherEstimator estimator(slowConfig());
  estimator.setBackgroundStart(true);
  run(1, 4, estimator);
  TetherEstimator copy = estimator;
  estimator.reset();
  EXPECT_EQ(estimator.phase(), Phase::IDLE);
  int k = 4;
  for (; k < 20000 && !(estimator.isRunning() && copy.isRunning()); ++k)
  {
    run(k, k + 1, estimator);
    run(k, k + 1, copy);
  }
  EXPECT_TRUE(estimator.isRunning());
  EXPECT_TRUE(copy.isRunning());
}

TEST(BackgroundStart, WhatComesMeanwhileCounts)
{
  Config config = slowConfig();
  config.environment.seabed = core::Seabed();
  TetherEstimator estimator(config);
  estimator.setBackgroundStart(true);
  run(1, 4, estimator);
  estimator.setDepth(444.0);
  core::Obstacle ball;
  ball.size = {1.0, 0.0, 0.0};
  ball.position = {1000.0, 0.0, -50.0};
  for (int k = 4; k < 20000 && !estimator.isRunning(); ++k)
  {
    run(k, k + 1, estimator);
    if (k == 6)
    {
      EXPECT_TRUE(estimator.setObstacles(0.3, {ball}).empty());
    }
  }
  ASSERT_TRUE(estimator.isRunning());
  EXPECT_EQ(estimator.simulation().model.environment().seabed()->depth, 444.0);
  EXPECT_EQ(estimator.simulation().model.environment().obstacles().size(), 1u);
}

TEST(BackgroundStart, AnEstimatorMayGoBeforeItsSearchHasEnded)
{
  auto estimator = std::make_unique<TetherEstimator>(slowConfig());
  estimator->setBackgroundStart(true);
  run(1, 4, *estimator);
  estimator.reset();
}

}  // namespace tether_monitor::monitor
