#include "tether_monitor/core/environment/obstacle.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/ball.h"
#include "support/matrix_compare.h"
#include "support/tethers.h"

namespace tether_monitor::core
{
class Shapes : public ::testing::TestWithParam<int>
{
};

TEST_P(Shapes, NormalIsTheGradientOfTheDistanceAndItsCurvatureTheSecondDerivative)
{
  RandomElement random(static_cast<unsigned>(GetParam()) + 100u);
  Obstacle obstacle;
  obstacle.shape = static_cast<ObstacleShape>(GetParam() % 3);
  obstacle.size = {1.0, 3.0, 2.0};
  obstacle.orientation =
      Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(0, 3), random.vector(1.0).normalized()));
  const Vector3 at = random.vector(2.5);
  const SignedDistance here = signedDistance(obstacle, at);
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 step = h * Vector3::Unit(i);
    const SignedDistance hi = signedDistance(obstacle, at + step), lo = signedDistance(obstacle, at - step);
    EXPECT_NEAR(here.normal[i], (hi.distance - lo.distance) / (2 * h), 1e-6);
    if (here.distance > 0.0)
    {
      EXPECT_TRUE(matricesNear(here.curvature.col(i), (hi.normal - lo.normal) / (2 * h), 1e-5));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Shapes, ::testing::Range(0, 60));

TEST(Shapes, DistancesOfKnownPoints)
{
  Obstacle cylinder;
  cylinder.shape = ObstacleShape::CYLINDER;
  cylinder.size = {0.5, 4.0, 0.0};
  EXPECT_NEAR(signedDistance(cylinder, {2.0, 0.0, 1.0}).distance, 1.5, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, {0.0, 0.0, 3.0}).distance, 1.0, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, {3.5, 0.0, 6.0}).distance, 5.0, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, {0.3, 0.0, 0.0}).distance, -0.2, 1e-12);
  Obstacle box;
  box.shape = ObstacleShape::BOX;
  box.size = {2.0, 2.0, 2.0};
  EXPECT_NEAR(signedDistance(box, {4.0, 5.0, 0.0}).distance, 5.0, 1e-12);
  EXPECT_NEAR(signedDistance(box, {0.9, 0.0, 0.2}).distance, -0.1, 1e-12);
  EXPECT_NEAR(signedDistance(ball(2.0, Vector3::Zero()), {0.0, 3.0, 0.0}).distance, 1.0, 1e-12);
}

}  // namespace tether_monitor::core
