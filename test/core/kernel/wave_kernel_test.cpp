#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tether_monitor/core/environment/wave_field.h"
#include "tether_monitor/core/kernel/kernel.h"

namespace tether_monitor::core
{
namespace
{
using kernel::BLOCK;

SeaState regular(double amplitude, double length)
{
  SeaState waves;
  waves.components = {{amplitude, length, 0.7, 0.3}};
  return waves;
}

SeaState irregular(int components)
{
  SeaState waves;
  waves.spectrum.emplace();
  waves.spectrum->significant_height = 2.5;
  waves.spectrum->peak_period = 8.0;
  waves.spectrum->components = components;
  return waves;
}

struct Water
{
  double velocity[3][BLOCK]{}, acceleration[3][BLOCK]{}, surface[BLOCK]{};
};

Water sample(const kernel::Kernel& with, const WaveField& waves, const double (&place)[3][BLOCK], double t)
{
  Water water;
  with.waves({place[0], place[1], place[2], BLOCK, t, waves.constants().data(),
              static_cast<int>(waves.constants().size()), waves.depth(), waves.isStretched(), water.velocity[0],
              water.acceleration[0], water.surface});
  return water;
}
}  // namespace

TEST(WaveKernel, IsTheWaveFieldAtEveryPointAndTimeForEveryInstructionSet)
{
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> across(-3e4, 3e4), down(-300.0, 4.0), when(0.0, 1e5);
  for (const kernel::Kernel* with : kernel::available())
    for (SeaState sea : {regular(0.6, 80.0), irregular(100), irregular(17)})
      for (const double depth : {AiryWave::DEEP, 300.0})
        for (const WaveStretching stretching : {WaveStretching::WHEELER, WaveStretching::NONE})
        {
          sea.stretching = stretching;
          const WaveField waves(sea, 9.81, depth);
          for (int round = 0; round < 50; ++round)
          {
            double place[3][BLOCK];
            for (int i = 0; i < BLOCK; ++i)
            {
              place[0][i] = across(generator);
              place[1][i] = across(generator);
              place[2][i] = i == 0 ? -0.5 : down(generator);
            }
            const double t = when(generator);
            const Water water = sample(*with, waves, place, t);
            for (int i = 0; i < BLOCK; ++i)
            {
              const WaveMotion one = waves.at(Vector3(place[0][i], place[1][i], place[2][i]), t);
              ASSERT_NEAR(water.surface[i], one.elevation, 1e-9) << with->name;
              for (int k = 0; k < 3; ++k)
              {
                ASSERT_NEAR(water.velocity[k][i], one.velocity[k], 1e-9) << with->name << " at " << place[2][i];
                ASSERT_NEAR(water.acceleration[k][i], one.acceleration[k], 1e-9) << with->name;
              }
            }
          }
        }
}

TEST(WaveKernel, AddsToTheCurrentAndLeavesCalmWaterAsItIs)
{
  const double place[3][BLOCK] = {{0.0}, {0.0}, {-10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0, -10.0}};
  const WaveField calm;
  for (const kernel::Kernel* with : kernel::available())
  {
    Water water;
    for (int i = 0; i < BLOCK; ++i)
    {
      water.velocity[0][i] = 0.5;
      water.acceleration[2][i] = water.surface[i] = 7.0;
    }
    with->waves({place[0], place[1], place[2], BLOCK, 3.0, nullptr, 0, calm.depth(), true, water.velocity[0],
                 water.acceleration[0], water.surface});
    for (int i = 0; i < BLOCK; ++i)
    {
      EXPECT_EQ(water.velocity[0][i], 0.5);
      EXPECT_EQ(water.acceleration[2][i], 0.0);
      EXPECT_EQ(water.surface[i], 0.0);
    }
  }
}

// A position that is no number gives water that is none: a step ends with a reason, not with a guess.
TEST(WaveKernel, OfNoPlaceKnowsNothing)
{
  const WaveField waves(regular(0.6, 80.0), 9.81);
  double place[3][BLOCK] = {};
  place[0][3] = std::nan("");
  for (const kernel::Kernel* with : kernel::available())
  {
    const Water water = sample(*with, waves, place, 0.0);
    EXPECT_TRUE(std::isnan(water.velocity[0][3]) && std::isnan(water.surface[3])) << with->name;
    EXPECT_TRUE(std::isfinite(water.velocity[0][2])) << with->name;
  }
}

}  // namespace tether_monitor::core
