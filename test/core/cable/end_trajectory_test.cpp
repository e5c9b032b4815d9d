#include "tether_monitor/core/cable/end_trajectory.h"

#include <gtest/gtest.h>

namespace tether_monitor::core
{
TEST(EndTrajectory, PassesThroughBothEndsWithTheirVelocities)
{
  const EndMotion from{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}}, to{{2.0, 2.0, 2.0}, {-1.0, 0.0, 1.0}};
  const EndTrajectory path = EndTrajectory::between(10.0, from, 10.5, to);
  EXPECT_LT((path.position(10.0) - from.position).norm() + (path.velocity(10.0) - from.velocity).norm(), 1e-12);
  EXPECT_LT((path.position(10.5) - to.position).norm() + (path.velocity(10.5) - to.velocity).norm(), 1e-12);
  const double h = 1e-5;
  EXPECT_LT(((path.velocity(10.2 + h) - path.velocity(10.2 - h)) / (2 * h) - path.acceleration(10.2)).norm(),
            1e-6);
}

TEST(EndTrajectory, VelocityIsTheDerivativeOfPosition)
{
  const EndTrajectory path =
      EndTrajectory::between(3.0, {{0.0, 1.0, -5.0}, {1.0, 0.0, 2.0}}, 5.0, {{4.0, 0.0, -6.0}, {0.0, 3.0, -1.0}});
  const double h = 1e-5;
  for (const double t : {3.1, 4.0, 4.9})
    EXPECT_LT(((path.position(t + h) - path.position(t - h)) / (2.0 * h) - path.velocity(t)).norm(), 1e-8) << t;
}

TEST(EndTrajectory, FromRestToRestItIsTheSmoothStep)
{
  const EndTrajectory path =
      EndTrajectory::between(0.0, {Vector3::Zero(), Vector3::Zero()}, 2.0, {{8.0, 0.0, 0.0}, Vector3::Zero()});
  EXPECT_NEAR(path.position(1.0).x(), 4.0, 1e-14);
  EXPECT_NEAR(path.velocity(1.0).x(), 6.0, 1e-14) << "one and a half times the mean";
  EXPECT_NEAR(path.acceleration(0.0).x(), 12.0, 1e-13);
  EXPECT_NEAR(path.acceleration(2.0).x(), -12.0, 1e-13);
}

TEST(EndTrajectory, UniformMotionGoesOnForEver)
{
  const EndTrajectory path = EndTrajectory::uniform(10.0, {{1.0, 2.0, 3.0}, {0.5, 0.0, -0.25}});
  EXPECT_EQ(path.at(14.0).position, Vector3(3.0, 2.0, 2.0));
  EXPECT_EQ(path.at(8.0).position, Vector3(0.0, 2.0, 3.5)) << "before, too";
  EXPECT_EQ(path.at(1000.0).velocity, Vector3(0.5, 0.0, -0.25));
  EXPECT_EQ(path.acceleration(14.0), Vector3::Zero());
}
}  // namespace tether_monitor::core
