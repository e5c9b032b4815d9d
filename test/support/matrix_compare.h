#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>

/// Largest difference of two matrices within `tolerance`; NaN against a number, or different sizes, fail.
template <typename A, typename B>
::testing::AssertionResult matricesNear(const Eigen::MatrixBase<A>& a, const Eigen::MatrixBase<B>& b,
                                        double tolerance)
{
  if (a.rows() != b.rows() || a.cols() != b.cols())
    return ::testing::AssertionFailure() << "sizes differ";
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      if (!(std::abs(a(i, j) - b(i, j)) <= tolerance))
        return ::testing::AssertionFailure() << "entry (" << i << ", " << j << "): " << a(i, j) << " against "
                                             << b(i, j) << ", tolerance " << tolerance;
  return ::testing::AssertionSuccess();
}
