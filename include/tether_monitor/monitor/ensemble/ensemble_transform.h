#pragma once

#include <vector>

#include "tether_monitor/monitor/ensemble/member_statistics.h"

namespace tether_monitor::monitor
{
/**
 * The ensemble transform Kalman filter for one measurement of up to three components, (E5) of
 * doc/theory/estimation.md: Bishop, Etherton and Majumdar (2001), the symmetric square root of Hunt, Kostelich and
 * Szunyogh (2007), by eigenvectors of the measurement's three components instead of the members'.
 *
 * What it does to one quantity of the members it does to all that goes with it.
 */
class EnsembleTransform
{
 public:
  explicit EnsembleTransform(int members = 0)
    : weights_(Eigen::RowVectorXd::Zero(members)), directions_(MemberVectors::Zero(3, members))
  {
  }

  /**
   * @param predicted   what every member predicts of the measurement.
   * @param innovation  measured less the mean of what is predicted.
   * @param covariance  of the innovation of a single member: what would be left if all its parameters were right.
   */
  void set(const MemberVectors& predicted, const core::Vector3& innovation, const core::Matrix3& covariance);
  /// Applies it to quantities of the members, one column each.
  void apply(Eigen::Ref<Eigen::MatrixXd> quantities) const;
  bool isValid() const { return weights_.allFinite() && directions_.allFinite() && shrinking_.allFinite(); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(weights_, directions_, shrinking_);
  }

 private:
  Eigen::RowVectorXd weights_;                       // of the anomalies in the change of the mean
  MemberVectors directions_;                         // orthonormal, in the space of the members
  core::Vector3 shrinking_ = core::Vector3::Zero();  // of the anomalies along them, 0..1
};

}  // namespace tether_monitor::monitor
