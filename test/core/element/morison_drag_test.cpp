#include "tether_monitor/core/element/morison_drag.h"

#include <gtest/gtest.h>

#include "support/matrix_compare.h"
#include "support/tethers.h"

namespace tether_monitor::core
{
TEST(MorisonDrag, MatchesHandCalculation)
{
  // u = 3 along, 4 across a tether along x: along 0.5 * 9, across 2 * 16.
  const Vector3 force = morisonDragForce<Vector3>(2.0, 0.5, {3.0, 4.0, 0.0}, {2.0, 0.0, 0.0});
  EXPECT_TRUE(matricesNear(force, Vector3(4.5, 32.0, 0.0), 1e-14));
}

TEST(MorisonDrag, VanishesWithoutFlowAndOpposesIt)
{
  EXPECT_EQ(morisonDragForce<Vector3>(2.0, 0.5, Vector3::Zero(), {1.0, 1.0, 0.0}).norm(), 0.0);
  const Vector3 u(0.3, -0.2, 0.9);
  EXPECT_GT(morisonDragForce<Vector3>(2.0, 0.5, u, {0.1, 0.7, 0.6}).dot(u), 0.0);
}

TEST(MorisonDrag, WithoutADirectionAllFlowIsNormal)
{
  const Vector3 u(0.0, 3.0, 4.0);
  EXPECT_TRUE(matricesNear(morisonDragForce<Vector3>(2.0, 0.5, u, Vector3::Zero()), Vector3(10.0 * u), 1e-12));
}

class MorisonDragProperty : public ::testing::TestWithParam<unsigned>
{
};

TEST_P(MorisonDragProperty, AnElementInUniformMotionFeelsItAllAlong)
{
  RandomElement random(GetParam());
  ElementParameters& p = random.p;
  p.bending_stiffness = p.axial.damping = 0.0;
  const Vector3 direction = random.vector(1.0).normalized(), u = random.vector(2.0);
  ElementMotion motion{ElementCoords::Zero(), ElementCoords::Zero(), ElementCoords::Zero()};
  motion.q << 0, 0, -100, direction, Vector3(0, 0, -100) + p.length * direction, direction;
  motion.v << u, Vector3::Zero(), u, Vector3::Zero();
  const EnvironmentModel sea{Environment()};
  ElementCoords residual;
  elementResidual(p, sea, motion, residual);
  const double half_rho_d = 0.5 * sea.density() * p.diameter;
  Vector3 expected = p.length * morisonDragForce<Vector3>(half_rho_d * p.drag_normal,
                                                          half_rho_d * p.drag_tangential, u, direction);
  expected.z() += p.length * sea.gravity() * (p.mass - sea.density() * p.area);
  const Vector3 force = residual.segment<3>(0) + residual.segment<3>(6);
  EXPECT_TRUE(matricesNear(force, expected, 1e-10 * (1.0 + expected.norm())));
}

INSTANTIATE_TEST_SUITE_P(Seeds, MorisonDragProperty, ::testing::Range(1u, 21u));

}  // namespace tether_monitor::core
