#include "tether_monitor/core/base/so3.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
TEST(ExpSO3, TurnsAboutItsDirectionByItsLength)
{
  const Eigen::Quaterniond quarter = expSO3(Vector3(0.0, 0.0, M_PI / 2.0));
  EXPECT_TRUE(matricesNear(quarter * Vector3::UnitX(), Vector3::UnitY(), 1e-15));
  const Vector3 turn(0.3, -1.1, 0.7);
  EXPECT_TRUE(matricesNear(expSO3(turn).toRotationMatrix(),
                           Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix(), 1e-14));
}

TEST(ExpSO3, IsAUnitQuaternionThatTheOppositeTurnUndoes)
{
  for (const double size : {0.0, 1e-12, 0.9e-8, 1.1e-8, 0.5, 4.0})
  {
    const Vector3 turn = size * Vector3(2.0, -1.0, 2.0) / 3.0;
    EXPECT_NEAR(expSO3(turn).norm(), 1.0, 1e-15) << size;
    EXPECT_NEAR((expSO3(turn) * expSO3(-turn)).angularDistance(Eigen::Quaterniond::Identity()), 0.0, 1e-15)
        << size;
  }
}

TEST(ExpSO3, ASmallTurnMovesByTheCrossProduct)
{
  const Vector3 turn(1e-9, 2e-9, -3e-9), arm(4.0, 5.0, 6.0);
  EXPECT_TRUE(matricesNear(expSO3(turn).vec(), 0.5 * turn, 1e-24));
  EXPECT_TRUE(matricesNear(expSO3(turn) * arm - arm, skew(turn) * arm, 1e-14));
}

TEST(Skew, IsTheCrossProductAndTurnsItsSignWhenTransposed)
{
  const Vector3 a(1.0, 2.0, 3.0), b(-4.0, 5.0, 7.0);
  EXPECT_EQ(skew(a) * b, Vector3(-1.0, -19.0, 13.0));
  EXPECT_EQ(skew(a).transpose(), -skew(a));
}
}  // namespace tether_monitor::core
