#pragma once

#include <Eigen/Eigenvalues>

#include "tether_monitor/monitor/ensemble/random_numbers.h"

namespace tether_monitor::monitor
{
/// N independent standard normal numbers.
template <int N>
Eigen::Matrix<double, N, 1> normals(RandomNumbers& random)
{
  Eigen::Matrix<double, N, 1> x;
  for (int k = 0; k < N; ++k)
    x[k] = random.normal();
  return x;
}

/// What makes of standard normal numbers those of a covariance, which may be singular.
template <int N>
Eigen::Matrix<double, N, N> squareRoot(const Eigen::Matrix<double, N, N>& covariance)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, N, N>> eigen(covariance);
  return eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();
}

}  // namespace tether_monitor::monitor
