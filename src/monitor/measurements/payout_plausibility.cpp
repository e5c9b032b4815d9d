#include "tether_monitor/monitor/measurements/payout_plausibility.h"

#include <cmath>

#include "tether_monitor/monitor/measurements/payout_buffer.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double RESOLUTION = 0.15;                  // of a counter [m]
constexpr double LONGEST_GAP = 5.0;                  // [s] between reports; beyond, the length may be any
constexpr int LEAPS_BELIEVED = 4;                    // so many in a row are the truth
constexpr double WINDOW = 1.0;                       // [s] over which the rate is held against the length
constexpr double RATE_OFF = 0.05, RATE_SHARE = 0.2;  // [m/s], of the displacement: a rate may be off
}  // namespace

PayoutPlausibility::Verdict PayoutPlausibility::check(double t, double length, double rate)
{
  Verdict verdict = Verdict::GOOD;
  const auto within = [&](double from, double since)
  { return std::abs(length - from) <= RESOLUTION + PayoutBuffer::FASTEST * (t - since); };
  if (has_report_ && t - t_ < LONGEST_GAP && !within(length_, t_))
  {
    leaps_ = leaps_ > 0 && within(leap_length_, leap_time_) ? leaps_ + 1 : 1;
    leap_time_ = t;
    leap_length_ = length;
    last_leap_ = t;
    if (leaps_ < LEAPS_BELIEVED)
      return Verdict::DOUBTFUL;
    verdict = Verdict::REACQUIRED;
    last_other_ = t;
  }
  leaps_ = 0;
  if (verdict == Verdict::REACQUIRED || !has_report_ || t - t_ >= LONGEST_GAP || std::isnan(rate) ||
      std::isnan(rate_))
  {
    began_ = t;
    from_ = length;
    integrated_ = 0.0;
  }
  else
  {
    compareRate(t, length, rate);
  }
  has_report_ = true;
  t_ = t;
  length_ = length;
  rate_ = rate;
  return verdict;
}

void PayoutPlausibility::compareRate(double t, double length, double rate)
{
  integrated_ += 0.5 * (t - t_) * (rate_ + rate);
  const double duration = t - began_;
  if (duration < WINDOW)
    return;
  const double change = length - from_;
  trusts_rate_ =
      std::abs(change - integrated_) <= RESOLUTION + RATE_OFF * duration + RATE_SHARE * std::abs(change);
  if (!trusts_rate_)
    (change == 0.0 ? last_frozen_ : last_contradiction_) = t;
  began_ = t;
  from_ = length;
  integrated_ = 0.0;
}

}  // namespace tether_monitor::monitor
