#include "tether_monitor/core/environment/airy_wave.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
TEST(AiryWave, DispersionInDeepAndShallowWater)
{
  const WaveProperties waves{0.5, 100.0, 0.0, 0.0};
  const double k = 2.0 * M_PI / 100.0;
  EXPECT_NEAR(AiryWave(waves, 9.81).frequency(), std::sqrt(9.81 * k), 1e-12);
  EXPECT_NEAR(AiryWave(waves, 9.81, 2.0).frequency() / k, std::sqrt(9.81 * 2.0), 0.02) << "long wave: sqrt(g h)";
}

TEST(AiryWave, SurfaceMovesWithTheWaterAndNothingCrossesTheFloor)
{
  for (const double depth : {AiryWave::DEEP, 12.0})
  {
    const AiryWave wave({0.4, 60.0, 0.7, 0.3}, 9.81, depth);
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
      EXPECT_TRUE(matricesNear(now.acceleration, change, 0.06 * 0.4 * wave.frequency() * wave.frequency()));
      if (std::isfinite(depth))
      {
        EXPECT_NEAR(wave.at(Vector3(3.0, 4.0, -depth), t).velocity.z(), 0.0, 1e-12);
      }
    }
  }
}

TEST(AiryWave, EncounterFrequencyRisesAgainstTheWaves)
{
  const AiryWave wave({0.5, 80.0, 0.0, 0.0}, 9.81);
  EXPECT_NEAR(wave.encounterFrequency(Vector3(-3.0, 1.0, 0.0)), wave.frequency() + 3.0 * 2.0 * M_PI / 80.0, 1e-12);
}

TEST(Waves, RefuseBreaking)
{
  EXPECT_FALSE(validate(WaveProperties{8.0, 100.0, 0.0, 0.0}).empty());
  EXPECT_FALSE(validate(WaveProperties{1.0, 0.0, 0.0, 0.0}).empty());
  EXPECT_FALSE(validate(WaveProperties{-1.0, 100.0, 0.0, 0.0}).empty());
  EXPECT_TRUE(validate(WaveProperties{7.0, 100.0, 0.0, 0.0}).empty());
}

}  // namespace tether_monitor::core
