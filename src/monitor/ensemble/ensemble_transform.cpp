#include "tether_monitor/monitor/ensemble/ensemble_transform.h"

#include <Eigen/Dense>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double NOTHING = 1e-12;  // an eigenvalue that tells nothing
}

void EnsembleTransform::set(const MemberVectors& predicted, const core::Vector3& innovation,
                            const core::Matrix3& covariance)
{
  const Eigen::Index n = predicted.cols();
  const core::Matrix3 whitening = Eigen::SelfAdjointEigenSolver<core::Matrix3>(covariance).operatorInverseSqrt();
  const core::Vector3 mean = predicted.rowwise().mean();
  const double scale = 1.0 / std::sqrt(static_cast<double>(n - 1));
  for (Eigen::Index i = 0; i < n; ++i)
    directions_.col(i) = scale * (whitening * (predicted.col(i) - mean));
  core::Matrix3 gram = core::Matrix3::Zero();
  for (Eigen::Index i = 0; i < n; ++i)
    gram += directions_.col(i) * directions_.col(i).transpose();
  const Eigen::SelfAdjointEigenSolver<core::Matrix3> eigen(gram);
  const core::Vector3 lambda = eigen.eigenvalues().cwiseMax(0.0);
  const core::Vector3 d = eigen.eigenvectors().transpose() * (whitening * innovation);
  const core::Vector3 gain = d.cwiseQuotient(core::Vector3::Ones() + lambda);
  core::Matrix3 normalise = eigen.eigenvectors().transpose();
  for (int k = 0; k < 3; ++k)
  {
    normalise.row(k) *= lambda[k] > NOTHING ? 1.0 / std::sqrt(lambda[k]) : 0.0;
    shrinking_[k] = 1.0 - 1.0 / std::sqrt(1.0 + lambda[k]);
  }
  const core::Vector3 to_weights = eigen.eigenvectors() * gain;
  for (Eigen::Index i = 0; i < n; ++i)
  {
    weights_[i] = scale * to_weights.dot(directions_.col(i));
    directions_.col(i) = (normalise * directions_.col(i)).eval();
  }
}

void EnsembleTransform::apply(Eigen::Ref<Eigen::MatrixXd> quantities) const
{
  const Eigen::Index n = quantities.cols();
  for (Eigen::Index row = 0; row < quantities.rows(); ++row)
  {
    const double mean = quantities.row(row).mean();
    double change = 0.0;
    core::Vector3 along = core::Vector3::Zero();
    for (Eigen::Index i = 0; i < n; ++i)
    {
      const double anomaly = quantities(row, i) - mean;
      change += weights_[i] * anomaly;
      along += anomaly * directions_.col(i);
    }
    const core::Vector3 less = shrinking_.cwiseProduct(along);
    for (Eigen::Index i = 0; i < n; ++i)
      quantities(row, i) += change - less.dot(directions_.col(i));
  }
}

}  // namespace tether_monitor::monitor
