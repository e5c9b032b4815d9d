#pragma once

#include <algorithm>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::monitor
{
/// Three numbers for each member, a column each.
using MemberVectors = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// Variance of a number over the members.
inline double varianceOf(const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& x)
{
  const double mean = x.mean();
  return (x.array() - mean).square().sum() / static_cast<double>(x.size() - 1);
}

/// Covariance of three numbers over the members. Allocates nothing.
inline core::Matrix3 covarianceOf(const Eigen::Ref<const MemberVectors, 0, Eigen::OuterStride<>>& x)
{
  const core::Vector3 mean = x.rowwise().mean();
  core::Matrix3 sum = core::Matrix3::Zero();
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    sum += (x.col(i) - mean) * (x.col(i) - mean).transpose();
  return sum / static_cast<double>(x.cols() - 1);
}

/// The value below which a share (0..1) of at least two sorted ones lie, in between linear.
inline double quantile(const Eigen::Ref<const Eigen::RowVectorXd, 0, Eigen::InnerStride<>>& sorted, double share)
{
  const double last = static_cast<double>(sorted.size() - 1);
  const double at = std::clamp(share * static_cast<double>(sorted.size()) - 0.5, 0.0, last);
  const auto k = std::min<Eigen::Index>(static_cast<Eigen::Index>(at), sorted.size() - 2);
  return sorted[k] + (at - static_cast<double>(k)) * (sorted[k + 1] - sorted[k]);
}

}  // namespace tether_monitor::monitor
