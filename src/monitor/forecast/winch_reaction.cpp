#include "tether_monitor/monitor/forecast/winch_reaction.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double MEMORY = 20.0, SLOW_MEMORY = 5.0;  // [s]
constexpr double INDEPENDENT = 2.0;                 // [s] after which an error of the regression is another
constexpr double VELOCITY_NOISE = 0.02;             // of an estimated velocity [m/s]
// Another rate than before, and not a fluctuation: so many standard deviations, and at least so much [m/s].
constexpr double SIGMAS = 3.0, LEAST_CHANGE = 0.05;
}  // namespace

void WinchReaction::observe(double t, double rate, double away)
{
  if (!memory_.isContinuedAt(t))
    clear();
  const bool is_first = memory_.isEmpty();
  const double dt = memory_.advance(t);
  const double share_of_now = memory_.shareOfNow(dt, MEMORY);
  regression_.observe(share_of_now, away, rate);
  if (is_first)
  {
    slow_rate_ = rate;
    return;
  }
  const double rest = rate - share() * (away - slowVelocity()) - slow_rate_;
  const bool is_another = std::abs(rest) > SIGMAS * std::sqrt(fluctuation_) + LEAST_CHANGE;
  fluctuation_ += share_of_now * (rest * rest - fluctuation_);
  slow_rate_ += (is_another ? 1.0 : FadingMemory::passed(dt, SLOW_MEMORY)) * rest;
}

bool WinchReaction::isValid() const
{
  return memory_.isValid() && regression_.isValid() && std::isfinite(slow_rate_) && fluctuation_ >= 0.0;
}

// As much of the least-squares slope as is beyond its own uncertainty.
double WinchReaction::share() const
{
  const double signal = regression_.varianceX() - VELOCITY_NOISE * VELOCITY_NOISE;
  if (signal <= 0.0)
    return 0.0;
  const double slope = std::clamp(regression_.covariance() / signal, 0.0, LARGEST_SHARE);
  const double variance = regression_.left(slope) / (memory_.independent(MEMORY, INDEPENDENT) * signal);
  return slope > 0.0 ? slope * std::max(1.0 - variance / (slope * slope), 0.0) : 0.0;
}

double WinchReaction::smoothed(double slow, double now, double dt)
{
  return slow + FadingMemory::passed(dt, MEMORY) * (now - slow);
}

double WinchReaction::away(const core::CableState& state, const core::Vector3& velocity)
{
  return -velocity.dot(state.q.front().tail<3>().normalized());
}

}  // namespace tether_monitor::monitor
