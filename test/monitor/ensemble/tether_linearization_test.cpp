#include "tether_monitor/monitor/ensemble/tether_linearization.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

namespace tether_monitor::monitor
{
namespace
{
using core::Matrix3;

constexpr double LOW = TetherLinearization::FIT_RATE_LOW, HIGH = TetherLinearization::FIT_RATE_HIGH;

double leastEigenvalue(const Matrix3& matrix)
{
  return Eigen::SelfAdjointEigenSolver<Matrix3>(0.5 * (matrix + matrix.transpose())).eigenvalues()[0];
}

}  // namespace

TEST(TetherLinearization, FindsWhatIsThere)
{
  TetherLinearization fit;
  fit.mass = 18.0 * Matrix3::Identity();
  Matrix3 damping, stiffness;
  damping << 40.0, 3.0, 0.0, 1.0, 60.0, 2.0, 0.0, 2.0, 90.0;
  stiffness << 2.0, 0.1, 0.0, 0.1, 1.0, 0.0, 0.2, 0.0, 0.5;
  const auto at = [&](double rate) -> Matrix3 { return rate * rate * fit.mass + rate * damping + stiffness; };
  EXPECT_TRUE(fit.fitMotion(at(LOW), at(HIGH)));
  EXPECT_LT((fit.damping - damping).norm(), 1e-9);
  EXPECT_LT((fit.stiffness - stiffness).norm(), 1e-9);
}

// Figures of a neutral tether of 60 m under a vehicle of 18 kg, nearly slack: a line through both rates has a
// damping of -2400 N s/m along one axis, and a motion that grows a hundredfold in a twentieth of a second.
TEST(TetherLinearization, ASlackTetherDoesNotDriveItsVehicle)
{
  TetherLinearization fit;
  fit.mass = 18.0 * Matrix3::Identity();
  const Matrix3 slow = core::Vector3(1.2, 1.2, 1.5).asDiagonal();
  const Matrix3 fast = core::Vector3(-435.0, 12.0, 14.0).asDiagonal();
  EXPECT_FALSE(fit.fitMotion(slow, fast));
  EXPECT_GE(leastEigenvalue(fit.damping), -1e-9);
  EXPECT_GE(leastEigenvalue(fit.stiffness), -1e-9);
  EXPECT_LE(fit.growthRate(), 1e-6);
  EXPECT_NEAR(fit.stiffness(0, 0), slow(0, 0), 0.01) << "what a slow motion feels is kept";
}

// Drag in a flow pushes a little to the side: a quadratic form may be negative where every motion decays.
TEST(TetherLinearization, WhatOnlyTurnsAsideIsKept)
{
  TetherLinearization fit;
  fit.mass = 150.0 * Matrix3::Identity();
  Matrix3 damping = 200.0 * Matrix3::Identity(), stiffness = 3.0 * Matrix3::Identity();
  stiffness(0, 1) = 20.0;
  const auto at = [&](double rate) -> Matrix3 { return rate * rate * fit.mass + rate * damping + stiffness; };
  ASSERT_LT(leastEigenvalue(stiffness), -5.0) << "precondition";
  EXPECT_TRUE(fit.fitMotion(at(LOW), at(HIGH)));
  EXPECT_LT((fit.stiffness - stiffness).norm(), 1e-9);
  EXPECT_LT(fit.growthRate(), 0.0);
}

}  // namespace tether_monitor::monitor
