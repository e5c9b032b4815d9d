#include "tether_monitor/ros/cycle_statistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor
{
namespace
{
constexpr double WINDOW = 10.0;       // [s]
constexpr double LATE = 0.5;          // periods
constexpr long MOST_MISSED = 100000;  // in one gap
}  // namespace

void LatencyStatistics::add(double seconds)
{
  most_ = std::max(most_, seconds);
  if (samples_.size() < CAPACITY)
    return samples_.push_back(seconds);
  samples_[next_] = seconds;
  next_ = (next_ + 1) % CAPACITY;
}

double LatencyStatistics::quantile(double share) const
{
  if (samples_.empty())
    return std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sorted = samples_;
  const auto at =
      sorted.begin() + std::lround(std::clamp(share, 0.0, 1.0) * static_cast<double>(sorted.size() - 1));
  std::nth_element(sorted.begin(), at, sorted.end());
  return *at;
}

CycleStatistics::CycleStatistics(double period)
  : period_(period), late_(std::max(1L, std::lround(std::min(WINDOW / period, 1e5))), 0)
{
}

void CycleStatistics::note(bool is_late)
{
  late_count_ += is_late;
  late_count_ -= late_[next_];
  late_[next_] = is_late;
  next_ = (next_ + 1) % late_.size();
  noted_ = std::min(noted_ + 1, late_.size());
}

void CycleStatistics::add(double lateness)
{
  const long missed = std::clamp(static_cast<long>(std::floor(lateness / period_ + 1e-9)), 0L, MOST_MISSED);
  for (long k = 0; k < std::min<long>(missed, static_cast<long>(late_.size())); ++k)
    note(true);
  missed_ += missed;
  ++cycles_;
  note(lateness > LATE * period_);
  lateness_.add(lateness);
}

double CycleStatistics::lateShare() const
{
  return noted_ == 0 ? 0.0 : static_cast<double>(late_count_) / static_cast<double>(noted_);
}

}  // namespace tether_monitor
