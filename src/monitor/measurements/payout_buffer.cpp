#include "tether_monitor/monitor/measurements/payout_buffer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tether_monitor::monitor
{
namespace
{
constexpr double SHORTEST_SLOPE = 0.1;  // [s]
constexpr double LONGEST_FADE = 1.0;    // [s]
}  // namespace

// Slope from a report that is old enough for its rounding not to matter.
double PayoutBuffer::slopeTo(double t, double length) const
{
  for (std::size_t i = count_; i-- > 0;)
    if (t - reports_[i].t >= SHORTEST_SLOPE)
      return (length - reports_[i].length) / (t - reports_[i].t);
  return count_ > 0 ? last().rate : 0.0;
}

bool PayoutBuffer::add(double t, double length, double rate)
{
  if (count_ > 0 && !(t > last().t))
    return false;
  if (std::isnan(rate))
    rate = slopeTo(t, length);
  if (count_ == CAPACITY)
  {
    std::move(reports_.begin() + 1, reports_.end(), reports_.begin());
    --count_;
  }
  if (count_ == 0)
    blender_.reset();
  reports_[count_++] = {t, length, rate};
  return true;
}

double PayoutBuffer::age(double t) const
{
  for (std::size_t i = count_; i-- > 0;)
    if (reports_[i].t <= t)
      return t - reports_[i].t;
  return count_ > 0 ? 0.0 : std::numeric_limits<double>::infinity();
}

core::PayoutState PayoutBuffer::reported(double t) const
{
  if (t <= reports_[0].t)
    return {reports_[0].length, reports_[0].rate, 0.0};
  for (std::size_t i = 1; i < count_; ++i)
    if (t <= reports_[i].t)
      return core::PayoutTrajectory::between(reports_[i - 1].t,
                                             {reports_[i - 1].length, reports_[i - 1].rate, 0.0}, reports_[i].t,
                                             {reports_[i].length, reports_[i].rate, 0.0})
          .at(t);
  return {last().length + last().rate * (t - last().t), last().rate, 0.0};
}

core::PayoutState PayoutBuffer::blend(double t)
{
  const core::PayoutState now = reported(t);
  const double interval = count_ > 1 ? std::min(last().t - reports_[count_ - 2].t, LONGEST_FADE) : 0.0;
  const auto target = blender_.blend(t, {now.length, now.rate}, last().t, interval);
  return {target.value, target.rate, now.acceleration};
}

bool PayoutBuffer::isValid() const
{
  bool sound = count_ <= CAPACITY;
  for (std::size_t i = 0; sound && i < count_; ++i)
    sound = std::isfinite(reports_[i].t) && std::isfinite(reports_[i].length) && std::isfinite(reports_[i].rate) &&
            (i == 0 || reports_[i].t > reports_[i - 1].t);
  return sound;
}

}  // namespace tether_monitor::monitor
