#include "tether_monitor/core/environment/environment_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
namespace
{
Environment slopingSea()
{
  Environment sea;
  sea.current = CurrentProfile(Vector3(0.5, 0.0, 0.0));
  sea.waves.components = {{1.0, 60.0, 0.0, 0.0}};
  sea.seabed = Seabed();
  sea.seabed->depth = 100.0;
  sea.seabed->slope = {0.1, 0.0};
  return sea;
}

const Vector3 POINT(5.0, 1.0, -4.0);
}  // namespace

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

TEST(EnvironmentModel, AnotherOriginMovesTheFloorAndTheWavesUnderThePoint)
{
  const EnvironmentModel sea(slopingSea());
  const EnvironmentModel moved = sea.withOrigin(Vector3(20.0, 3.0, 0.0));
  EXPECT_EQ(sea.origin(), Vector3::Zero());
  EXPECT_NEAR(sea.floorAt(Vector3::Zero()).z, -100.0, 1e-12);
  EXPECT_NEAR(moved.floorAt(Vector3::Zero()).z, -102.0, 1e-12);
  const WaterKinematics here = moved.waterKinematics(POINT, 1.5);
  const WaterKinematics there = sea.waterKinematics(POINT + Vector3(20.0, 3.0, 0.0), 1.5);
  EXPECT_TRUE(matricesNear(here.velocity, there.velocity, 1e-12));
  EXPECT_NEAR(here.surface, there.surface, 1e-12);
  EXPECT_GT((here.velocity - sea.waterKinematics(POINT, 1.5).velocity).norm(), 0.01) << "a third of a wave away";
}

TEST(EnvironmentModel, AnotherTimeOriginIsAnotherTimeInTheWaves)
{
  const EnvironmentModel sea(slopingSea());
  const EnvironmentModel later = sea.withTimeOrigin(1000.0);
  EXPECT_EQ(later.timeOrigin(), 1000.0);
  EXPECT_EQ(sea.timeOrigin(), 0.0);
  const WaterKinematics now = later.waterKinematics(POINT, 2.0), then = sea.waterKinematics(POINT, 1002.0);
  EXPECT_TRUE(matricesNear(now.velocity, then.velocity, 1e-9));
  EXPECT_TRUE(matricesNear(now.acceleration, then.acceleration, 1e-9));
}

TEST(EnvironmentModel, WithoutWavesTheCurrentAndTheFloorStay)
{
  const EnvironmentModel sea(slopingSea());
  const EnvironmentModel calm = sea.withoutWaves();
  EXPECT_FALSE(sea.isUniform());
  EXPECT_TRUE(calm.isUniform());
  EXPECT_EQ(calm.waterKinematics(POINT, 2.0).velocity, Vector3(0.5, 0.0, 0.0));
  EXPECT_EQ(calm.waterKinematics(POINT, 2.0).acceleration, Vector3::Zero());
  EXPECT_EQ(calm.floorAt(POINT).z, sea.floorAt(POINT).z);
}

TEST(EnvironmentModel, CurrentObstaclesAndDepthChangeNothingElse)
{
  const EnvironmentModel sea(slopingSea());
  const EnvironmentModel streaming = sea.withCurrent(CurrentProfile(Vector3(0.0, 2.0, 0.0)));
  EXPECT_TRUE(
      matricesNear(streaming.waterKinematics(POINT, 1.0).velocity - sea.waterKinematics(POINT, 1.0).velocity,
                   Vector3(-0.5, 2.0, 0.0), 1e-12))
      << "the waves stay";
  EXPECT_EQ(streaming.floorAt(POINT).z, sea.floorAt(POINT).z);

  Obstacle ball;
  ball.size[0] = 1.0;
  const EnvironmentModel obstructed = sea.withObstacles({ball});
  EXPECT_EQ(obstructed.obstacles().size(), 1u);
  EXPECT_TRUE(sea.obstacles().empty());
  EXPECT_EQ(obstructed.waterKinematics(POINT, 1.0).velocity, sea.waterKinematics(POINT, 1.0).velocity);

  const EnvironmentModel deeper = sea.withDepth(250.0);
  EXPECT_EQ(deeper.floorAt(Vector3(70.0, 0.0, 0.0)).z, -250.0) << "level";
  EXPECT_NEAR(sea.floorAt(Vector3(70.0, 0.0, 0.0)).z, -107.0, 1e-12);
  EXPECT_EQ(deeper.current().at(-1.0), sea.current().at(-1.0));
  EXPECT_EQ(deeper.seabed()->friction, sea.seabed()->friction);
}
}  // namespace tether_monitor::core
