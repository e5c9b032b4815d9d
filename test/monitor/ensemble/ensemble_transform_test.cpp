#include "tether_monitor/monitor/ensemble/ensemble_transform.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tether_monitor/monitor/ensemble/random_numbers.h"

namespace tether_monitor::monitor
{
using core::Matrix3;
using core::Vector3;

namespace
{
constexpr int MEMBERS = 40, STATES = 7;

Eigen::MatrixXd drawn(unsigned seed)
{
  Eigen::MatrixXd x(STATES, MEMBERS);
  RandomNumbers random(seed);
  random.fillUncorrelated(x);
  return x;
}

Eigen::MatrixXd covariance(const Eigen::MatrixXd& x)
{
  const Eigen::MatrixXd a = x.colwise() - x.rowwise().mean();
  return a * a.transpose() / (x.cols() - 1);
}
}  // namespace

TEST(RandomNumbers, ASampleHasItsMomentsExactly)
{
  const Eigen::MatrixXd x = drawn(3);
  EXPECT_LT(x.rowwise().mean().norm(), 1e-12);
  EXPECT_LT((covariance(x) - Eigen::MatrixXd::Identity(STATES, STATES)).norm(), 1e-12);
  RandomNumbers random(1);
  double sum = 0.0, square = 0.0;
  for (int i = 0; i < 20000; ++i)
  {
    const double z = random.normal();
    sum += z;
    square += z * z;
  }
  EXPECT_NEAR(sum / 20000, 0.0, 0.03);
  EXPECT_NEAR(square / 20000, 1.0, 0.04);
}

// For a linear measurement of a Gaussian it is Kalman's update.
TEST(EnsembleTransform, IsTheKalmanFilterOfALinearMeasurement)
{
  Eigen::MatrixXd mix = Eigen::MatrixXd::Identity(STATES, STATES);
  mix(0, 3) = 0.7;
  mix(2, 5) = -0.4;
  Eigen::MatrixXd x = (mix * drawn(5)).colwise() + Eigen::VectorXd::LinSpaced(STATES, -1.0, 2.0);
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(3, STATES);
  H(0, 0) = 1.0;
  H(1, 2) = 2.0;
  H(1, 4) = 0.5;
  H(2, 6) = -1.0;
  Matrix3 S;
  S << 0.5, 0.1, 0.0, 0.1, 0.8, 0.2, 0.0, 0.2, 1.5;
  const Vector3 z(0.4, -1.0, 2.0);
  const Eigen::VectorXd mean = x.rowwise().mean();
  const Eigen::MatrixXd P = covariance(x);
  const Eigen::MatrixXd K = P * H.transpose() * (H * P * H.transpose() + S).inverse();

  EnsembleTransform transform(MEMBERS);
  const Vector3 innovation = z - H * mean;
  transform.set(H * x, innovation, S);
  transform.apply(x);
  EXPECT_LT((x.rowwise().mean() - mean - K * innovation).norm(), 1e-10);
  EXPECT_LT((covariance(x) - P + K * H * P).norm(), 1e-10);
}

TEST(EnsembleTransform, WhatTellsNothingChangesNothing)
{
  Eigen::MatrixXd x = drawn(5);
  const Eigen::MatrixXd before = x;
  EnsembleTransform transform(MEMBERS);
  transform.set(MemberVectors::Constant(3, MEMBERS, 2.0), Vector3::Ones(), Matrix3::Identity());
  transform.apply(x);
  EXPECT_LT((x - before).norm(), 1e-12) << "all predict the same";
  transform.set(x.topRows<3>(), Vector3::Ones(), 1e15 * Matrix3::Identity());
  transform.apply(x);
  EXPECT_LT((x - before).norm(), 1e-6) << "nobody knows how good it is";
}
}  // namespace tether_monitor::monitor
