#include "tether_monitor/core/environment/wave_field.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
namespace
{
SeaState regular(double amplitude, WaveStretching stretching = WaveStretching::WHEELER)
{
  SeaState waves;
  waves.components = {{amplitude, 60.0, 0.7, 0.3}};
  waves.stretching = stretching;
  return waves;
}
}  // namespace

TEST(WaveField, SurfaceMovesWithTheWaterAndNothingCrossesTheFloor)
{
  for (const double depth : {AiryWave::DEEP, 12.0})
  {
    const WaveField wave(regular(0.4), 9.81, depth);
    const double w = wave.dominant().frequency();
    const double h = 1e-5;
    for (double t = 0.0; t < 8.0; t += 1.1)
    {
      const double eta = wave.elevation(3.0, 4.0, t);
      const double rising = (wave.elevation(3.0, 4.0, t + h) - wave.elevation(3.0, 4.0, t - h)) / (2.0 * h);
      EXPECT_NEAR(wave.at(Vector3(3.0, 4.0, eta), t).velocity.z(), rising, 1e-6) << "linear kinematic condition";
      const WaveMotion now = wave.at(Vector3(3.0, 4.0, -5.0), t);
      const Vector3 change =
          (wave.at(Vector3(3.0, 4.0, -5.0), t + h).velocity - wave.at(Vector3(3.0, 4.0, -5.0), t - h).velocity) /
          (2.0 * h);
      // The stretching moves with the surface: its own rate, of the order a k, is not part of the linear wave.
      EXPECT_TRUE(matricesNear(now.acceleration, change, 0.06 * 0.4 * w * w));
      if (std::isfinite(depth))
      {
        EXPECT_NEAR(wave.at(Vector3(3.0, 4.0, -depth), t).velocity.z(), 0.0, 1e-12);
      }
    }
  }
}

TEST(WaveField, WithoutStretchingTheAccelerationIsTheRateOfTheVelocityAndTheAirFeelsStillWatersSurface)
{
  const WaveField wave(regular(1.5, WaveStretching::NONE), 9.81, 40.0);
  const double h = 1e-5;
  for (double t = 0.0; t < 8.0; t += 1.1)
  {
    const Vector3 place(3.0, 4.0, -5.0);
    const Vector3 change = (wave.at(place, t + h).velocity - wave.at(place, t - h).velocity) / (2.0 * h);
    EXPECT_TRUE(matricesNear(wave.at(place, t).acceleration, change, 1e-7));
    EXPECT_TRUE(matricesNear(wave.at(Vector3(3.0, 4.0, 1.0), t).velocity,
                             wave.at(Vector3(3.0, 4.0, 0.0), t).velocity, 0.0));
  }
}

TEST(WaveField, WheelerPutsStillWatersVelocityAtTheSurface)
{
  const WaveField stretched(regular(1.5), 9.81), plain(regular(1.5, WaveStretching::NONE), 9.81);
  for (double t = 0.0; t < 8.0; t += 1.1)
    EXPECT_TRUE(matricesNear(stretched.at(Vector3(0.0, 0.0, stretched.elevation(0.0, 0.0, t)), t).velocity,
                             plain.at(Vector3::Zero(), t).velocity, 1e-12));
}

TEST(WaveField, WavesAddUp)
{
  const WaveProperties first{0.5, 60.0, 0.7, 0.3}, second{0.3, 25.0, -1.2, 2.0};
  SeaState a, b, both;
  a.components = {first};
  b.components = {second};
  both.components = {first, WaveProperties(), second};
  for (SeaState* each : {&a, &b, &both})
    each->stretching = WaveStretching::NONE;
  const WaveField one(a, 9.81, 30.0), other(b, 9.81, 30.0), sum(both, 9.81, 30.0);
  const Vector3 place(11.0, -7.0, -3.0);
  EXPECT_NEAR(sum.at(place, 4.0).elevation, one.elevation(11.0, -7.0, 4.0) + other.elevation(11.0, -7.0, 4.0),
              1e-12);
  EXPECT_TRUE(matricesNear(sum.at(place, 4.0).velocity,
                           one.at(place, 4.0).velocity + other.at(place, 4.0).velocity, 1e-12));
  EXPECT_TRUE(matricesNear(sum.at(place, 4.0).acceleration,
                           one.at(place, 4.0).acceleration + other.at(place, 4.0).acceleration, 1e-12));
  EXPECT_EQ(sum.components().size(), 2u) << "a wave without height is none";
  EXPECT_EQ(sum.dominant().amplitude(), 0.5);
}

TEST(WaveField, ASpectrumsDominantWaveIsThatOfItsPeak)
{
  SeaState waves;
  waves.spectrum = WaveSpectrum();
  waves.spectrum->significant_height = 2.0;
  waves.spectrum->peak_period = 8.0;
  const WaveField sea(waves, 9.81);
  EXPECT_EQ(sea.components().size(), 100u);
  EXPECT_NEAR(sea.dominant().frequency(), 2.0 * M_PI / 8.0, 1e-9);
  EXPECT_TRUE(WaveField().isCalm());
}

}  // namespace tether_monitor::core
