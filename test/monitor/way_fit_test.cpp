#include "tether_monitor/monitor/way_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace tether_monitor::monitor
{
namespace
{
std::vector<WaySample> measure(double duration, double interval, double noise,
                               const std::function<double(double)>& motion, unsigned seed = 4)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<WaySample> samples;
  for (double t = 100.0; t < 100.0 + duration + 1e-9; t += interval)
    samples.push_back({t, motion(t) + noise * normal(generator), noise});
  return samples;
}

Way fit(const std::vector<WaySample>& samples, bool level = false)
{
  return fitWay(samples.data(), samples.size(), samples.back().t, level);
}
}  // namespace

TEST(WayFit, TakesNoWaveForASpeed)
{
  // A little more than a period: a line alone is up to 0.15 m/s off.
  for (const double phase : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
  {
    const auto motion = [&](double t) { return 1000.0 + 3.0 * t + 0.9 * std::sin(0.66 * t + phase); };
    const Way way = fit(measure(10.0, 0.2, 0.02, motion));
    EXPECT_NEAR(way.velocity, 3.0, 0.03) << phase;
    EXPECT_NEAR(way.position, 1330.0, 0.15) << phase;
    EXPECT_NEAR(way.wave_rate, 0.66, 0.1) << phase;
    EXPECT_NEAR(way.wave_height, 0.9 / std::sqrt(2.0), 0.15) << phase;
    EXPECT_LT(std::abs(way.velocity - 3.0), 2.0 * way.velocity_stddev) << phase;
  }
}

TEST(WayFit, DoubtsASpeedUnderWavesAndNoneInFlatWater)
{
  const auto sea = [](double t) { return 2.0 * t + std::sin(0.8 * t) + 0.7 * std::sin(0.55 * t + 1.0); };
  const Way way = fit(measure(20.0, 0.2, 0.02, sea));
  EXPECT_NEAR(way.velocity, 2.0, 3.0 * way.velocity_stddev);
  EXPECT_GT(way.velocity_stddev, 0.02);
  EXPECT_LT(way.velocity_stddev, 0.1);
  const Way flat = fit(measure(20.0, 0.2, 0.02, [](double t) { return 2.0 * t; }));
  EXPECT_NEAR(flat.velocity, 2.0, 0.005);
  EXPECT_LT(flat.velocity_stddev, 0.002);
}

// Longer than the samples: it cannot be told from a way, and the standard deviation says so.
TEST(WayFit, KnowsThatALongSwellLooksLikeAWay)
{
  for (const double period : {12.0, 15.0, 18.0, 22.0})
  {
    double square = 0.0, claimed = 0.0;
    constexpr int RUNS = 40;
    for (int run = 0; run < RUNS; ++run)
    {
      const double w = 2.0 * M_PI / period, phase = 2.0 * M_PI * run / RUNS;
      const auto motion = [&](double t) { return 3.0 * t + std::sin(w * t + phase); };
      const Way way = fit(measure(10.0, 0.2, 0.02, motion, run));
      square += std::pow(way.velocity - 3.0, 2) / RUNS;
      claimed += std::pow(way.velocity_stddev, 2) / RUNS;
    }
    EXPECT_LT(square, 2.0 * claimed) << period;
    EXPECT_LT(claimed, std::pow(0.35, 2)) << period;
  }
}

// Pierson and Moskowitz's spectrum: no sines.
TEST(WayFit, KnowsHowMuchAnIrregularSeaHides)
{
  for (const double height : {0.5, 2.0, 5.0})
    for (const double duration : {10.0, 20.0})
    {
      constexpr int RUNS = 100, WAVES = 60;
      double within = 0.0, claimed = 0.0;
      for (int run = 0; run < RUNS; ++run)
      {
        std::mt19937 generator(run);
        std::normal_distribution<double> normal;
        double w[WAVES], a[WAVES], b[WAVES], sum = 0.0;
        for (int k = 0; k < WAVES; ++k)
        {
          w[k] = 0.35 + 0.03 * k;
          const double x = std::pow(0.7 / w[k], 4),
                       size = std::sqrt(std::pow(0.7 / w[k], 5) * std::exp(-1.25 * x));
          a[k] = size * normal(generator);
          b[k] = size * normal(generator);
          sum += size * size;
        }
        const auto motion = [&](double t)
        {
          double y = 3.0 * t;
          for (int k = 0; k < WAVES; ++k)
            y += 0.25 * height / std::sqrt(sum) * (a[k] * std::cos(w[k] * t) + b[k] * std::sin(w[k] * t));
          return y;
        };
        const Way way = fit(measure(duration, 0.2, 0.02, motion, run));
        within += std::abs(way.velocity - 3.0) < 2.0 * way.velocity_stddev;
        claimed += way.velocity_stddev / RUNS;
      }
      EXPECT_GT(within / RUNS, duration < 15.0 ? 0.75 : 0.95) << height << " m, " << duration << " s";
      EXPECT_LT(claimed, 0.1 * height) << height << " m, " << duration << " s";
    }
}

TEST(WayFit, TakesNoNoiseForWaves)
{
  int waves = 0;
  double square = 0.0, claimed = 0.0;
  constexpr int RUNS = 100;
  for (const double noise : {0.02, 0.5, 2.0})
    for (int run = 0; run < RUNS; ++run)
    {
      const Way way = fit(measure(
          11.0, noise > 1.0 ? 1.0 : 0.2, noise, [](double t) { return 3.0 * t; }, run));
      waves += way.wave_rate > 0.0;
      if (noise > 1.0)
      {
        square += std::pow(way.velocity - 3.0, 2) / RUNS;
        claimed += std::pow(way.velocity_stddev, 2) / RUNS;
      }
    }
  EXPECT_LT(waves, 15);
  EXPECT_LT(square, 1.5 * claimed);
  EXPECT_GT(square, claimed / 3.0);
}

TEST(WayFit, GoodSamplesCountForMoreThanPoorOnes)
{
  std::vector<WaySample> samples = measure(10.0, 0.1, 0.03, [](double) { return 5.0; });
  for (std::size_t i = 0; i < samples.size(); i += 4)
    samples[i] = {samples[i].t, 8.0, 5.0};
  const Way way = fit(samples, true);
  EXPECT_NEAR(way.position, 5.0, 0.03);
  EXPECT_EQ(way.wave_rate, 0.0);
}

TEST(WayFit, HeaveTellsWhichWavesAreThere)
{
  // Sway in a sea of 9.5 s, over which a slow swerve lies; alone it could be a swell of twenty seconds.
  const auto sway = [](double t) { return 0.04 * (t - 100.0) + 0.24 * std::sin(0.66 * t + 2.5); };
  const Way heave = fit(measure(10.0, 0.05, 0.03, [](double t) { return std::sin(0.66 * t); }), true);
  const std::vector<WaySample> samples = measure(10.0, 0.2, 0.02, sway);
  const Way alone = fit(samples),
            told = fitWay(samples.data(), samples.size(), samples.back().t, false, heave.odds);
  EXPECT_NEAR(told.velocity, 0.04, 0.05);
  EXPECT_LT(told.velocity_stddev, 0.8 * alone.velocity_stddev);
}

TEST(WayFit, LeavesOutWhatIsFarOff)
{
  std::vector<WaySample> samples =
      measure(10.0, 0.2, 0.02, [](double t) { return 3.0 * t + 0.9 * std::sin(0.66 * t); });
  samples[3].value += 40.0;
  samples[40].value -= 25.0;
  EXPECT_NEAR(fit(samples).velocity, 3.0, 0.05);
}

TEST(WayFit, AVesselDoesNotClimb)
{
  const Way way = fit(measure(13.0, 0.05, 0.03, [](double t) { return -2.0 + 0.5 * std::sin(0.9 * t); }), true);
  EXPECT_EQ(way.velocity, 0.0);
  EXPECT_EQ(way.velocity_stddev, 0.0);
  EXPECT_NEAR(way.position, -2.0, 0.03);
}

TEST(WayFit, MakesTheBestOfFewSamples)
{
  const WaySample one{3.0, 7.0, 0.1};
  const Way still = fitWay(&one, 1, 3.0, false);
  EXPECT_NEAR(still.position, 7.0, 1e-9);
  EXPECT_NEAR(still.velocity, 0.0, 1e-6);
  EXPECT_GT(still.velocity_stddev, 5.0);
  const WaySample two[] = {{3.0, 7.0, 0.0}, {4.0, 9.0, 0.0}};
  const Way line = fitWay(two, 2, 5.0, false);
  EXPECT_NEAR(line.position, 11.0, 0.05);
  EXPECT_NEAR(line.velocity, 2.0, 0.05);
  EXPECT_GT(line.velocity_stddev, 0.1) << "two samples cannot tell a wave from a way";
  const WaySample same[] = {{3.0, 7.0, 0.1}, {3.0, 7.2, 0.1}};
  EXPECT_NEAR(fitWay(same, 2, 3.0, false).position, 7.1, 1e-3);
}
}  // namespace tether_monitor::monitor
