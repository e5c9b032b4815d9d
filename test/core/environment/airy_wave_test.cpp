#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "support/matrix_compare.h"
#include "tether_monitor/core/environment/environment_model.h"

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

TEST(Seabed, APlaneAndAGridOfThatPlaneAgree)
{
  Seabed plane;
  plane.depth = 80.0;
  plane.slope = {0.05, -0.1};
  auto grid = std::make_shared<DepthGrid>();
  grid->x0 = -100.0;
  grid->y0 = -50.0;
  grid->dx = 10.0;
  grid->dy = 5.0;
  grid->depth = Eigen::MatrixXd(21, 21);
  for (int i = 0; i < 21; ++i)
    for (int j = 0; j < 21; ++j)
      grid->depth(i, j) = 80.0 + 0.05 * (-100.0 + 10.0 * i) - 0.1 * (-50.0 + 5.0 * j);
  Seabed gridded;
  gridded.grid = grid;
  for (const auto& [x, y] : {std::pair(3.0, 4.0), {-77.7, 21.3}, {50.0, -30.0}})
  {
    EXPECT_NEAR(gridded.at(x, y).z, plane.at(x, y).z, 1e-9);
    EXPECT_TRUE(matricesNear(gridded.at(x, y).normal, plane.at(x, y).normal, 1e-9));
  }
  EXPECT_NEAR(gridded.at(1000.0, 0.0).z, gridded.at(100.0, 0.0).z, 1e-9) << "constant beyond the rim";
}

TEST(Seabed, NormalOfAGridIsThatOfItsSurface)
{
  auto grid = std::make_shared<DepthGrid>();
  grid->depth = Eigen::MatrixXd::Random(6, 5);
  Seabed seabed;
  seabed.grid = grid;
  const double h = 1e-6, x = 2.3, y = 1.6;
  const Vector3 n = seabed.at(x, y).normal;
  EXPECT_NEAR(-n.x() / n.z(), (seabed.at(x + h, y).z - seabed.at(x - h, y).z) / (2 * h), 1e-7);
  EXPECT_NEAR(-n.y() / n.z(), (seabed.at(x, y + h).z - seabed.at(x, y - h).z) / (2 * h), 1e-7);
}

TEST(EnvironmentRefuses, NamesWhatIsWrong)
{
  Environment sea;
  sea.seabed = Seabed();
  sea.seabed->friction = -1.0;
  sea.wind.x() = NAN;
  sea.obstacles.push_back(Obstacle());
  const std::vector<std::string> found = validate(sea);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_NE(found[0].find("environment.wind"), std::string::npos);
  EXPECT_NE(found[1].find("environment.seabed.friction"), std::string::npos);
  EXPECT_NE(found[2].find("environment.obstacles[0].size[0]"), std::string::npos);
  EXPECT_THROW(EnvironmentModel{sea}, std::invalid_argument);
}

}  // namespace tether_monitor::core
