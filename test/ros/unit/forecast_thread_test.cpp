#include "tether_monitor/ros/forecast_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "support/estimator_fixture.h"

namespace tether_monitor
{
TEST(ForecastBudget, ShedsMembersThenRateAndComesBack)
{
  const monitor::ForecastConfig config;
  ForecastBudget budget(config);
  EXPECT_EQ(budget.members(), config.members);
  EXPECT_FALSE(budget.isShort());
  budget.note(1.0);
  EXPECT_LT(budget.members(), config.members);
  EXPECT_GE(budget.members(), 16);
  EXPECT_DOUBLE_EQ(budget.interval(), 1.0) << "members go first";
  EXPECT_TRUE(budget.isShort());
  for (int k = 0; k < 10; ++k)
    budget.note(2.0);
  EXPECT_EQ(budget.members(), 16);
  EXPECT_GT(budget.interval(), 1.0);
  EXPECT_LE(budget.interval(), 10.0);
  for (int k = 0; k < 50; ++k)
    budget.note(0.01);
  EXPECT_EQ(budget.members(), config.members);
  EXPECT_DOUBLE_EQ(budget.interval(), 1.0);
  EXPECT_FALSE(budget.isShort());
}

TEST(ForecastThread, MakesThemOneAtATime)
{
  monitor::EstimatorFixture fixture(monitor::coarseConfig());
  fixture.run(12.0);
  const auto start = std::make_shared<const monitor::ForecastStart>(*fixture.estimator.forecastStart());
  std::atomic<int> made{0};
  double t = -1.0;
  {
    ForecastThread thread(monitor::coarseConfig(),
                          [&](const monitor::TetherForecast& forecast)
                          {
                            t = forecast.t;
                            ++made;
                          });
    EXPECT_TRUE(thread.isDue(start->t));
    thread.submit(start);
    thread.submit(start);
    while (made == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_FALSE(thread.isDue(start->t + 0.5)) << "not yet";
    EXPECT_GE(thread.whatIf(start, 5.0, monitor::ForecastActions()).members, 16);
  }
  EXPECT_EQ(made, 1) << "the second one came while the first was made";
  EXPECT_EQ(t, start->t);
}
}  // namespace tether_monitor
