#include "tether_monitor/monitor/forecast/forecast_score.h"

#include <gtest/gtest.h>

namespace tether_monitor::monitor
{
namespace
{
TetherForecast saying(double probability, int t)
{
  TetherForecast forecast;
  forecast.t = t;
  forecast.horizon = 30.0;
  forecast.members = 96;
  forecast.probability_over_tension = probability;
  return forecast;
}

// An hour in which the tether is past its limit for a second at every multiple of 100 s; once a second a forecast.
template <class Probability>
ForecastScore record(const Probability& probability)
{
  ForecastScore score;
  for (int t = 1; t <= 3600; ++t)
  {
    score.observe(t, t % 100 == 0);
    score.add(saying(probability(t), t), t % 100 == 0);
  }
  return score;
}
}  // namespace

TEST(ForecastScore, OneThatKnowsIsPerfect)
{
  const ForecastScore::Result r = record([](int t) { return t % 100 >= 70 ? 1.0 : 0.0; }).result();
  EXPECT_EQ(r.events, 36);
  EXPECT_EQ(r.warnings[0].warned, 36);
  EXPECT_EQ(r.warnings[0].false_warnings, 0);
  EXPECT_DOUBLE_EQ(r.brier_score, 0.0);
  EXPECT_DOUBLE_EQ(r.warnings[0].median_lead_time, 30.0);
  EXPECT_DOUBLE_EQ(r.reliability.front().observed, 0.0);
  EXPECT_DOUBLE_EQ(r.reliability.back().observed, 1.0);
}

TEST(ForecastScore, OneThatIsLateOrCriesWolf)
{
  const ForecastScore::Result late = record([](int t) { return t % 100 >= 95 ? 1.0 : 0.0; }).result();
  EXPECT_EQ(late.warnings[0].warned, 0);
  EXPECT_DOUBLE_EQ(late.warnings[0].median_lead_time, 5.0);
  EXPECT_NEAR(late.reliability.front().observed, 25.0 / 94.0, 0.01);
  const ForecastScore::Result unsure =
      record([](int t) { return t % 100 >= 70                   ? 0.9
                                : t % 100 >= 20 && t % 100 < 30 ? 0.6
                                                                : 0.0; }).result();
  EXPECT_EQ(unsure.warnings[0].false_warnings, 36);
  EXPECT_EQ(unsure.warnings[1].warned, 36);
  EXPECT_EQ(unsure.warnings[1].false_warnings, 0);
  EXPECT_EQ(unsure.warnings[2].warned, 0);
  const ForecastScore::Result wolf =
      record([](int t) { return t % 100 >= 20 && t % 100 < 30 ? 1.0 : 0.0; }).result();
  EXPECT_EQ(wolf.warnings[0].warnings, 36);
  EXPECT_EQ(wolf.warnings[0].false_warnings, 36);
  EXPECT_EQ(wolf.warnings[0].warned, 0);
}

// Half of a hundred tethers are past a limit that the estimate is just below, and nobody knows which: each
// forecast says one half, and is right.
TEST(ForecastScore, WhatNobodyKnowsDoesNotChooseTheForecasts)
{
  ForecastScore all;
  for (int dive = 0; dive < 100; ++dive)
  {
    ForecastScore score;
    for (int t = 1; t <= 300; ++t)
    {
      score.observe(t, dive % 2 == 0);
      score.add(saying(0.5, t), false);
    }
    all.add(score);
  }
  const ForecastScore::Result r = all.result();
  EXPECT_NEAR(r.reliability[3].observed, 0.5, 1e-9);
  EXPECT_EQ(r.warnings[0].warnings, 100);
  EXPECT_EQ(r.warnings[0].false_warnings, 50);
}

TEST(ForecastScore, AnHonestDoubtIsReliable)
{
  const ForecastScore score = record([](int) { return 0.3; });
  const ForecastScore::Result r = score.result();
  EXPECT_NEAR(r.reliability[2].observed, 30.0 / 99.0, 0.01);
  EXPECT_NEAR(r.reliability[2].mean_probability, 0.3, 1e-12);
  ForecastScore both;
  both.add(score);
  both.add(score);
  EXPECT_EQ(both.result().events, 2 * r.events);
  EXPECT_EQ(both.result().warnings[0].warnings, 0);
  EXPECT_NEAR(both.result().brier_score, r.brier_score, 1e-12);
}
}  // namespace tether_monitor::monitor
