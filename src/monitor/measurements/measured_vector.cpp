#include "tether_monitor/monitor/measurements/measured_vector.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
bool MeasuredVector::isValid() const
{
  for (int axis = 0; axis < 3; ++axis)
  {
    if (isMeasured(axis) && !std::isfinite(value_[axis]))
      return false;
    if (accuracy_[axis] == Accuracy::SPECIFIED &&
        !(covariance_(axis, axis) > 0.0 && covariance_.row(axis).allFinite()))
      return false;
  }
  return isPositiveSemidefinite();
}

bool MeasuredVector::isPositiveSemidefinite() const
{
  constexpr double ROUNDING = 1e-9;
  const core::Vector3 scale = covariance_.diagonal().cwiseMax(0.0).cwiseSqrt();
  core::Matrix3 correlation = core::Matrix3::Identity();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < i; ++j)
    {
      const double c = covariance_(i, j) == 0.0 ? 0.0 : covariance_(i, j) / (scale[i] * scale[j]);
      if (!(std::abs(c) <= 1.0 + ROUNDING))
        return false;
      correlation(i, j) = correlation(j, i) = c;
    }
  return correlation.determinant() >= -ROUNDING;
}

double MeasuredVector::stddev(int axis) const
{
  return std::sqrt(covariance_(axis, axis));
}

void MeasuredVector::reset(int axis, Accuracy accuracy)
{
  accuracy_[axis] = accuracy;
  covariance_.row(axis).setZero();
  covariance_.col(axis).setZero();
  if (accuracy == Accuracy::NOT_MEASURED)
    value_[axis] = 0.0;
}

MeasuredVector MeasuredVector::at(const core::Vector3& value) const
{
  MeasuredVector moved = *this;
  for (int axis = 0; axis < 3; ++axis)
    moved.value_[axis] = isMeasured(axis) ? value[axis] : 0.0;
  return moved;
}

MeasuredVector MeasuredVector::withDefaultStddev(double stddev) const
{
  MeasuredVector specified = *this;
  for (int axis = 0; axis < 3; ++axis)
    if (accuracy_[axis] == Accuracy::UNSPECIFIED)
    {
      specified.accuracy_[axis] = Accuracy::SPECIFIED;
      specified.covariance_(axis, axis) = stddev * stddev;
    }
  return specified;
}

// Variance is added along the axis: what is correlated stays a covariance.
MeasuredVector MeasuredVector::withLeastStddev(double least) const
{
  MeasuredVector floored = *this;
  for (int axis = 0; axis < 3; ++axis)
    if (accuracy_[axis] == Accuracy::SPECIFIED)
      floored.covariance_(axis, axis) = std::max(covariance_(axis, axis), least * least);
  return floored;
}

}  // namespace tether_monitor::monitor
