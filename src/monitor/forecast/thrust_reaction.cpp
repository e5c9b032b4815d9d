#include "tether_monitor/monitor/forecast/thrust_reaction.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double MEMORY = 20.0;       // [s]
constexpr double INDEPENDENT = 5.0;   // [s] after which an error of the regression is another
constexpr double FORCE_NOISE = 10.0;  // of an estimated force [N]
// Before anything is known every share is as probable.
constexpr double PRIOR_SHARE = 0.5, PRIOR_VARIANCE = 1.0 / 12.0;
}  // namespace

void ThrustReaction::observe(double t, const core::Vector3& thrust, const core::Vector3& tether_force)
{
  if (!memory_.isContinuedAt(t))
    clear();
  const bool is_first = memory_.isEmpty();
  const double dt = memory_.advance(t);
  force_ = tether_force;
  largest_ = std::max(largest_, thrust.norm());
  slow_force_ = is_first ? tether_force : smoothed(slow_force_, tether_force, dt);
  const double share = memory_.shareOfNow(dt, MEMORY);
  for (int k = 0; k < 3; ++k)
    axes_[k].observe(share, slow_force_[k], thrust[k]);
}

bool ThrustReaction::isValid() const
{
  const auto is_valid = [](const FadingRegression& axis) { return axis.isValid(); };
  return memory_.isValid() && largest_ >= 0.0 && force_.allFinite() && slow_force_.allFinite() &&
         std::all_of(axes_.begin(), axes_.end(), is_valid);
}

// Least squares with the prior: what the regression leaves unexplained is its noise.
ThrustReaction::Share ThrustReaction::share() const
{
  Share share;
  const double independent = memory_.independent(MEMORY, INDEPENDENT);
  for (int k = 0; k < 3; ++k)
  {
    const double signal = std::max(axes_[k].varianceX() - FORCE_NOISE * FORCE_NOISE, 0.0);
    const double slope = std::clamp(signal > 0.0 ? -axes_[k].covariance() / signal : 0.0, 0.0, 1.0);
    const double left = axes_[k].left(-slope);
    const double noise = (left + FORCE_NOISE * FORCE_NOISE) / independent;
    const double variance = 1.0 / (1.0 / PRIOR_VARIANCE + signal / noise);
    const double unknown = variance / PRIOR_VARIANCE;
    share.mean[k] = (1.0 - unknown) * slope + unknown * PRIOR_SHARE;
    share.stddev[k] = std::sqrt(variance);
  }
  return share;
}

core::Vector3 ThrustReaction::smoothed(const core::Vector3& slow, const core::Vector3& now, double dt)
{
  return slow + FadingMemory::passed(dt, RESPONSE) * (now - slow);
}

}  // namespace tether_monitor::monitor
