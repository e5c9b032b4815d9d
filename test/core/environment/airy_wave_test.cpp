#include "tether_monitor/core/environment/airy_wave.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::core
{
TEST(AiryWave, DispersionInDeepAndShallowWater)
{
  const WaveProperties waves{0.5, 100.0, 0.0, 0.0};
  const double k = 2.0 * M_PI / 100.0;
  EXPECT_NEAR(AiryWave(waves, 9.81).frequency(), std::sqrt(9.81 * k), 1e-12);
  EXPECT_NEAR(AiryWave(waves, 9.81, 2.0).frequency() / k, std::sqrt(9.81 * 2.0), 0.02) << "long wave: sqrt(g h)";
}

TEST(AiryWave, NothingCrossesTheFloorAndDeepWaterDiesAway)
{
  const AiryWave shallow({0.4, 60.0, 0.7, 0.3}, 9.81, 12.0), deep({0.4, 60.0, 0.7, 0.3}, 9.81);
  EXPECT_NEAR(shallow.profile(-12.0).up, 0.0, 1e-12);
  EXPECT_NEAR(shallow.profile(0.0).up, 0.4 * shallow.frequency(), 1e-12) << "the surface moves with the water";
  EXPECT_NEAR(deep.profile(-6.0).horizontal, 0.4 * deep.frequency() * std::exp(-2.0 * M_PI * 0.1), 1e-12);
  EXPECT_EQ(deep.profile(-1e4).horizontal, 0.0);
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
