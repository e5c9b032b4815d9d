#pragma once

#include <cmath>

namespace tether_monitor::monitor
{
/// Means, variances and covariance of a pair of numbers over a memory that fades. Plain data: copy it to save it.
class FadingRegression
{
 public:
  /// @param share  of this pair in what is remembered, 0..1; 1: nothing before it is.
  void observe(double share, double x, double y)
  {
    const double dx = x - mean_x_, dy = y - mean_y_;
    mean_x_ += share * dx;
    mean_y_ += share * dy;
    variance_x_ += share * ((1.0 - share) * dx * dx - variance_x_);
    variance_y_ += share * ((1.0 - share) * dy * dy - variance_y_);
    covariance_ += share * ((1.0 - share) * dx * dy - covariance_);
  }
  double meanX() const { return mean_x_; }
  double varianceX() const { return variance_x_; }
  double covariance() const { return covariance_; }
  /// Mean square of y that is left about a line of this slope.
  double left(double slope) const
  {
    return std::fmax(variance_y_ - 2.0 * slope * covariance_ + slope * slope * variance_x_, 0.0);
  }
  bool isValid() const
  {
    return std::isfinite(mean_x_) && std::isfinite(mean_y_) && variance_x_ >= 0.0 && variance_y_ >= 0.0 &&
           std::isfinite(covariance_);
  }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(mean_x_, mean_y_, variance_x_, variance_y_, covariance_);
  }

 private:
  double mean_x_ = 0.0, mean_y_ = 0.0, variance_x_ = 0.0, variance_y_ = 0.0, covariance_ = 0.0;
};

}  // namespace tether_monitor::monitor
