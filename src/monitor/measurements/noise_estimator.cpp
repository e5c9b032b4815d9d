#include "tether_monitor/monitor/measurements/noise_estimator.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double GAIN = 252.0;  // variance of a fifth difference of white noise of variance 1
constexpr double UNEVEN = 1.5;  // longest over shortest interval of a series
constexpr int MOST = 200;       // differences that are remembered
constexpr double WILD = 16.0;   // a square is counted as at most so many times the usual
}  // namespace

void DifferenceNoiseEstimator::add(double t, double value)
{
  if (count_ > 0 && !(t > t_[count_ - 1]))
    return;
  if (count_ == POINTS)
  {
    std::move(t_.begin() + 1, t_.end(), t_.begin());
    std::move(value_.begin() + 1, value_.end(), value_.begin());
    --count_;
  }
  t_[count_] = t;
  value_[count_] = value;
  ++count_;
  double shortest = 1e300, longest = 0.0;
  for (int i = 1; i < count_; ++i)
  {
    shortest = std::min(shortest, t_[i] - t_[i - 1]);
    longest = std::max(longest, t_[i] - t_[i - 1]);
  }
  if (count_ > 1 && longest > UNEVEN * shortest)
  {
    t_[0] = t;
    value_[0] = value;
    count_ = 1;
    return;
  }
  if (count_ < POINTS)
    return;
  const double difference =
      value_[5] - 5.0 * value_[4] + 10.0 * value_[3] - 10.0 * value_[2] + 5.0 * value_[1] - value_[0];
  double square = difference * difference / GAIN;
  if (samples_ >= ENOUGH)
    square = std::min(square, WILD * variance_ + LEAST * LEAST);
  samples_ = std::min(samples_ + 1, MOST);
  variance_ += (square - variance_) / samples_;
}

double DifferenceNoiseEstimator::stddev() const
{
  return samples_ < ENOUGH ? UNKNOWN : std::max(std::sqrt(variance_), LEAST);
}

}  // namespace tether_monitor::monitor
