#include "tether_monitor/monitor/vessel/track_wave_regression.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace tether_monitor::monitor
{
namespace
{
std::vector<TrackSample> measure(double duration, double interval, double noise,
                                 const std::function<double(double)>& motion, unsigned seed = 4)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  std::vector<TrackSample> samples;
  for (double t = 100.0; t < 100.0 + duration + 1e-9; t += interval)
    samples.push_back({t, motion(t) + noise * normal(generator), noise});
  return samples;
}

TrackFit fit(const std::vector<TrackSample>& samples, bool level = false)
{
  return fitTrackAndWave(samples.data(), samples.size(), samples.back().t, level);
}
}  // namespace

TEST(TrackFit, TakesNoWaveForASpeed)
{
  // A little more than a period: a line alone is up to 0.15 m/s off.
  for (const double phase : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0})
  {
    const auto motion = [&](double t) { return 1000.0 + 3.0 * t + 0.9 * std::sin(0.66 * t + phase); };
    const TrackFit track = fit(measure(10.0, 0.2, 0.02, motion));
    EXPECT_NEAR(track.velocity, 3.0, 0.03) << phase;
    EXPECT_NEAR(track.position, 1330.0, 0.15) << phase;
    EXPECT_NEAR(track.wave_frequency, 0.66, 0.1) << phase;
    EXPECT_NEAR(track.wave_stddev, 0.9 / std::sqrt(2.0), 0.15) << phase;
    EXPECT_LT(std::abs(track.velocity - 3.0), 2.0 * track.velocity_stddev) << phase;
  }
}

TEST(TrackFit, DoubtsASpeedUnderWavesAndNoneInFlatWater)
{
  const auto sea = [](double t) { return 2.0 * t + std::sin(0.8 * t) + 0.7 * std::sin(0.55 * t + 1.0); };
  const TrackFit track = fit(measure(20.0, 0.2, 0.02, sea));
  EXPECT_NEAR(track.velocity, 2.0, 3.0 * track.velocity_stddev);
  EXPECT_GT(track.velocity_stddev, 0.02);
  EXPECT_LT(track.velocity_stddev, 0.1);
  const TrackFit flat = fit(measure(20.0, 0.2, 0.02, [](double t) { return 2.0 * t; }));
  EXPECT_NEAR(flat.velocity, 2.0, 0.005);
  EXPECT_LT(flat.velocity_stddev, 0.002);
}

// Longer than the samples: it cannot be told from a track, and the standard deviation says so.
TEST(TrackFit, KnowsThatALongSwellLooksLikeAWay)
{
  for (const double period : {12.0, 15.0, 18.0, 22.0})
  {
    double square = 0.0, claimed = 0.0;
    constexpr int RUNS = 40;
    for (int run = 0; run < RUNS; ++run)
    {
      const double w = 2.0 * M_PI / period, phase = 2.0 * M_PI * run / RUNS;
      const auto motion = [&](double t) { return 3.0 * t + std::sin(w * t + phase); };
      const TrackFit track = fit(measure(10.0, 0.2, 0.02, motion, run));
      square += std::pow(track.velocity - 3.0, 2) / RUNS;
      claimed += std::pow(track.velocity_stddev, 2) / RUNS;
    }
    EXPECT_LT(square, 2.0 * claimed) << period;
    EXPECT_LT(claimed, std::pow(0.35, 2)) << period;
  }
}

// Pierson and Moskowitz's spectrum: no sines.
TEST(TrackFit, KnowsHowMuchAnIrregularSeaHides)
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
        const TrackFit track = fit(measure(duration, 0.2, 0.02, motion, run));
        within += std::abs(track.velocity - 3.0) < 2.0 * track.velocity_stddev;
        claimed += track.velocity_stddev / RUNS;
      }
      EXPECT_GT(within / RUNS, duration < 15.0 ? 0.75 : 0.95) << height << " m, " << duration << " s";
      EXPECT_LT(claimed, 0.1 * height) << height << " m, " << duration << " s";
    }
}

TEST(TrackFit, TakesNoNoiseForWaves)
{
  int waves = 0;
  double square = 0.0, claimed = 0.0;
  constexpr int RUNS = 100;
  for (const double noise : {0.02, 0.5, 2.0})
    for (int run = 0; run < RUNS; ++run)
    {
      const TrackFit track = fit(measure(
          11.0, noise > 1.0 ? 1.0 : 0.2, noise, [](double t) { return 3.0 * t; }, run));
      waves += track.wave_frequency > 0.0;
      if (noise > 1.0)
      {
        square += std::pow(track.velocity - 3.0, 2) / RUNS;
        claimed += std::pow(track.velocity_stddev, 2) / RUNS;
      }
    }
  EXPECT_LT(waves, 15);
  EXPECT_LT(square, 1.5 * claimed);
  EXPECT_GT(square, claimed / 3.0);
}

TEST(TrackFit, GoodSamplesCountForMoreThanPoorOnes)
{
  std::vector<TrackSample> samples = measure(10.0, 0.1, 0.03, [](double) { return 5.0; });
  for (std::size_t i = 0; i < samples.size(); i += 4)
    samples[i] = {samples[i].t, 8.0, 5.0};
  const TrackFit track = fit(samples, true);
  EXPECT_NEAR(track.position, 5.0, 0.03);
  EXPECT_EQ(track.wave_frequency, 0.0);
}

TEST(TrackFit, HeaveTellsWhichWavesAreThere)
{
  // Sway in a sea of 9.5 s, over which a slow swerve lies; alone it could be a swell of twenty seconds.
  const auto sway = [](double t) { return 0.04 * (t - 100.0) + 0.24 * std::sin(0.66 * t + 2.5); };
  const TrackFit heave = fit(measure(10.0, 0.05, 0.03, [](double t) { return std::sin(0.66 * t); }), true);
  const std::vector<TrackSample> samples = measure(10.0, 0.2, 0.02, sway);
  const TrackFit alone = fit(samples), told = fitTrackAndWave(samples.data(), samples.size(), samples.back().t,
                                                              false, heave.probabilities);
  EXPECT_NEAR(told.velocity, 0.04, 0.05);
  EXPECT_LT(told.velocity_stddev, 0.8 * alone.velocity_stddev);
}

TEST(TrackFit, LeavesOutWhatIsFarOff)
{
  std::vector<TrackSample> samples =
      measure(10.0, 0.2, 0.02, [](double t) { return 3.0 * t + 0.9 * std::sin(0.66 * t); });
  samples[3].value += 40.0;
  samples[40].value -= 25.0;
  EXPECT_NEAR(fit(samples).velocity, 3.0, 0.05);
}

TEST(TrackFit, AVesselDoesNotClimb)
{
  const TrackFit track =
      fit(measure(13.0, 0.05, 0.03, [](double t) { return -2.0 + 0.5 * std::sin(0.9 * t); }), true);
  EXPECT_EQ(track.velocity, 0.0);
  EXPECT_EQ(track.velocity_stddev, 0.0);
  EXPECT_NEAR(track.position, -2.0, 0.03);
}

TEST(TrackFit, MakesTheBestOfFewSamples)
{
  const TrackSample one{3.0, 7.0, 0.1};
  const TrackFit still = fitTrackAndWave(&one, 1, 3.0, false);
  EXPECT_NEAR(still.position, 7.0, 1e-9);
  EXPECT_NEAR(still.velocity, 0.0, 1e-6);
  EXPECT_GT(still.velocity_stddev, 5.0);
  const TrackSample two[] = {{3.0, 7.0, 0.0}, {4.0, 9.0, 0.0}};
  const TrackFit line = fitTrackAndWave(two, 2, 5.0, false);
  EXPECT_NEAR(line.position, 11.0, 0.05);
  EXPECT_NEAR(line.velocity, 2.0, 0.05);
  EXPECT_GT(line.velocity_stddev, 0.1) << "two samples cannot tell a wave from a track";
  const TrackSample same[] = {{3.0, 7.0, 0.1}, {3.0, 7.2, 0.1}};
  EXPECT_NEAR(fitTrackAndWave(same, 2, 3.0, false).position, 7.1, 1e-3);
}
}  // namespace tether_monitor::monitor
