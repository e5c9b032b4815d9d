#include "tether_monitor/core/morison_drag.h"

#include <gtest/gtest.h>

#include <random>

#include "core/support/compare.h"

namespace tether_monitor::core
{
TEST(MorisonDrag, MatchesHandCalculation)
{
  // u = 3 along, 4 across a tether along x: along 0.5 * 9, across 2 * 16.
  const Vector3 force = morisonDragForce(2.0, 0.5, {3.0, 4.0, 0.0}, {2.0, 0.0, 0.0});
  EXPECT_TRUE(matricesNear(force, Vector3(4.5, 32.0, 0.0), 1e-14));
}

TEST(MorisonDrag, VanishesWithoutFlowAndOpposesIt)
{
  EXPECT_EQ(morisonDragForce(2.0, 0.5, Vector3::Zero(), {1.0, 1.0, 0.0}).norm(), 0.0);
  const Vector3 u(0.3, -0.2, 0.9);
  EXPECT_GT(morisonDragForce(2.0, 0.5, u, {0.1, 0.7, 0.6}).dot(u), 0.0);
}

TEST(MorisonDrag, WithoutADirectionAllFlowIsNormal)
{
  const Vector3 u(0.0, 3.0, 4.0);
  EXPECT_TRUE(matricesNear(morisonDrag(2.0, 0.5, u, Vector3::Zero()).force, Vector3(10.0 * u), 1e-12));
}

class MorisonDragProperty : public ::testing::TestWithParam<unsigned>
{
};

TEST_P(MorisonDragProperty, DerivativesMatchDifferences)
{
  std::mt19937 g(GetParam());
  std::uniform_real_distribution<double> x(-2.0, 2.0);
  const Vector3 u(x(g), x(g), x(g)), slope(x(g), x(g), x(g));
  const DragLaw at = morisonDrag(1.3, 0.4, u, slope);
  EXPECT_TRUE(matricesNear(at.force, morisonDragForce(1.3, 0.4, u, slope), 1e-13));
  const double h = 1e-6;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3 d = h * Vector3::Unit(i);
    const Vector3 by_u =
        (morisonDragForce(1.3, 0.4, u + d, slope) - morisonDragForce(1.3, 0.4, u - d, slope)) / (2 * h);
    const Vector3 by_slope =
        (morisonDragForce(1.3, 0.4, u, slope + d) - morisonDragForce(1.3, 0.4, u, slope - d)) / (2 * h);
    EXPECT_TRUE(matricesNear(at.d_velocity.col(i), by_u, 1e-7));
    EXPECT_TRUE(matricesNear(at.d_slope.col(i), by_slope, 1e-6 * (1.0 + at.d_slope.norm())));
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, MorisonDragProperty, ::testing::Range(1u, 21u));

}  // namespace tether_monitor::core
