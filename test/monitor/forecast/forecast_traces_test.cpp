#include "tether_monitor/monitor/forecast/forecast_traces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
TetherEstimate tension(double largest, double place = 0.0)
{
  TetherEstimate e;
  e.max_tension = e.vessel_tension = largest;
  e.vehicle_tension = e.min_tension = 0.5 * largest;
  e.max_tension_s = place;
  e.working_utilisation = largest / 1000.0;
  e.breaking_utilisation = largest / 5000.0;
  return e;
}
}  // namespace

// Twenty members: member k grows to 100 (k + 1) N within ten seconds.
TEST(ForecastTraces, SharesTimesAndQuantiles)
{
  const ForecastLimits limits{Config()};
  ForecastTraces traces;
  traces.begin(20, 10.0, 0.5);
  for (int k = 0; k < 20; ++k)
  {
    for (int i = 1; i <= 50; ++i)
      traces.add(k, 0.2 * i, tension(100.0 * (k + 1) * i / 50.0, k), limits);
    traces.finish(k, {core::Vector3(k, 0.0, 0.0)});
  }
  TetherForecast f;
  traces.summarize(f);
  ASSERT_EQ(f.time.size(), 20u);
  EXPECT_DOUBLE_EQ(f.time.back(), 10.0);
  EXPECT_EQ(f.members, 20);
  EXPECT_NEAR(f.max_tension.back(), 1050.0, 1e-9);
  EXPECT_NEAR(f.max_tension_p95.back(), 1950.0, 1e-9);
  EXPECT_NEAR(f.max_tension_p05.back(), 150.0, 1e-9);
  EXPECT_NEAR(f.vehicle_tension.back(), 525.0, 1e-9);
  EXPECT_DOUBLE_EQ(f.probability_over_tension, 0.5) << "1100 to 2000 N of 1000 N";
  EXPECT_DOUBLE_EQ(f.probability_breaking, 0.0);
  EXPECT_DOUBLE_EQ(f.probability_slack, 0.0);
  EXPECT_NEAR(f.time_to_limit_p05, 5.2, 1e-9) << "of the one that gets to 2000 N";
  EXPECT_NEAR(f.time_to_limit, 6.6, 0.3) << "median of the ten that do";
  EXPECT_LT(f.time_to_warning, f.time_to_limit);
  EXPECT_TRUE(std::isnan(f.time_to_slack));
  EXPECT_NEAR(f.place_s, 9.5, 0.6) << "that of a median member";
  ASSERT_EQ(f.position.size(), 1u);
  EXPECT_EQ(f.position[0].x(), f.place_s) << "of the same member";
}

TEST(ForecastTraces, MembersThatAreLostDoNotCount)
{
  const ForecastLimits limits{Config()};
  ForecastTraces traces;
  traces.begin(3, 1.0, 0.5);
  for (int k = 0; k < 3; ++k)
    for (const double t : {0.5, 1.0})
      traces.add(k, t, tension(k == 2 ? 9000.0 : 100.0), limits);
  traces.drop(2);
  EXPECT_EQ(traces.alive(), 2);
  TetherForecast f;
  traces.summarize(f);
  EXPECT_EQ(f.members, 2);
  EXPECT_DOUBLE_EQ(f.probability_over_tension, 0.0);
  EXPECT_DOUBLE_EQ(f.max_tension_p95.back(), 100.0);
}
}  // namespace tether_monitor::monitor
