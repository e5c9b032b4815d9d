#pragma once

#include <array>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::monitor
{
/// What is known of one component of a measured vector.
enum class Accuracy
{
  NOT_MEASURED,  ///< nothing.
  UNSPECIFIED,   ///< its value; how good it is, the configuration or the data must tell.
  SPECIFIED      ///< its value and its part of the covariance.
};

/**
 * A vector of which some components were measured, with the covariance of those whose accuracy is specified.
 *
 * The one representation of "not measured" in the package: messages and files are converted to it at their border.
 */
class MeasuredVector
{
 public:
  /// Nothing was measured.
  MeasuredVector() { accuracy_.fill(Accuracy::NOT_MEASURED); }
  /// All components, accuracy unspecified.
  MeasuredVector(const core::Vector3& value) : value_(value)  // NOLINT: a vector is a measurement of all of it
  {
    accuracy_.fill(Accuracy::UNSPECIFIED);
  }
  /// All components. @param covariance  symmetric, positive definite.
  MeasuredVector(const core::Vector3& value, const core::Matrix3& covariance)
    : value_(value), covariance_(covariance)
  {
    accuracy_.fill(Accuracy::SPECIFIED);
  }
  /// All components, uncorrelated. @param stddev  of every one, > 0.
  static MeasuredVector withStddev(const core::Vector3& value, const core::Vector3& stddev)
  {
    return MeasuredVector(value, stddev.cwiseAbs2().asDiagonal());
  }

  const core::Vector3& value() const { return value_; }
  Accuracy accuracy(int axis) const { return accuracy_[axis]; }
  bool isMeasured(int axis) const { return accuracy_[axis] != Accuracy::NOT_MEASURED; }
  bool isComplete() const { return isMeasured(0) && isMeasured(1) && isMeasured(2); }
  bool isEmpty() const { return !isMeasured(0) && !isMeasured(1) && !isMeasured(2); }
  /// True if every measured component is finite, with a variance > 0 where it is specified, and the covariance is
  /// positive semidefinite.
  bool isValid() const;

  /// Of an axis whose accuracy is specified, > 0.
  double stddev(int axis) const;
  /// Entries of axes whose accuracy is not specified are zero.
  const core::Matrix3& covariance() const { return covariance_; }

  void setNotMeasured(int axis) { reset(axis, Accuracy::NOT_MEASURED); }
  void setUnspecified(int axis) { reset(axis, Accuracy::UNSPECIFIED); }
  /// The same at another place: covariance and accuracy stay.
  MeasuredVector at(const core::Vector3& value) const;
  /// The same with `stddev` where the accuracy is unspecified.
  MeasuredVector withDefaultStddev(double stddev) const;

  /// The same with standard deviations of `least` where they are told to be smaller.
  MeasuredVector withLeastStddev(double least) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(value_, accuracy_, covariance_);
  }

 private:
  bool isPositiveSemidefinite() const;
  void reset(int axis, Accuracy accuracy);

  core::Vector3 value_ = core::Vector3::Zero();
  std::array<Accuracy, 3> accuracy_{};
  core::Matrix3 covariance_ = core::Matrix3::Zero();
};

}  // namespace tether_monitor::monitor
