#include "tether_monitor/monitor/forecast/thrust_reaction.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double MEMORY = 20.0, LONGEST_GAP = 60.0;  // [s]
constexpr double INDEPENDENT = 5.0;                  // [s] after which an error of the regression is another
constexpr double FORCE_NOISE = 10.0;                 // of an estimated force [N]
// Before anything is known every share is as probable.
constexpr double PRIOR_SHARE = 0.5, PRIOR_VARIANCE = 1.0 / 12.0;
}  // namespace

void ThrustReaction::observe(double t, const core::Vector3& thrust, const core::Vector3& tether_force)
{
  const double dt = t - time_;
  if (observed_for_ > 0.0 && (dt <= 0.0 || dt > LONGEST_GAP))
    clear();
  time_ = t;
  force_ = tether_force;
  largest_ = std::max(largest_, thrust.norm());
  if (observed_for_ == 0.0)
  {
    slow_force_ = force_mean_ = tether_force;
    thrust_mean_ = thrust;
    observed_for_ = 1e-3;
    return;
  }
  observed_for_ += dt;
  slow_force_ = smoothed(slow_force_, tether_force, dt);
  const double share = 1.0 - std::exp(-dt / std::min(MEMORY, observed_for_));
  const core::Vector3 f = slow_force_ - force_mean_, u = thrust - thrust_mean_;
  force_mean_ += share * f;
  thrust_mean_ += share * u;
  force_square_ += share * ((1.0 - share) * f.cwiseAbs2() - force_square_);
  thrust_square_ += share * ((1.0 - share) * u.cwiseAbs2() - thrust_square_);
  product_ += share * ((1.0 - share) * f.cwiseProduct(u) - product_);
}

bool ThrustReaction::isValid() const
{
  return std::isfinite(time_) && observed_for_ >= 0.0 && largest_ >= 0.0 && force_.allFinite() &&
         slow_force_.allFinite() && thrust_mean_.allFinite() && force_mean_.allFinite() &&
         force_square_.allFinite() && thrust_square_.allFinite() && product_.allFinite();
}

// Least squares with the prior: what the regression leaves unexplained is its noise.
ThrustReaction::Share ThrustReaction::share() const
{
  Share share;
  const double independent = std::max(std::min(observed_for_, 2.0 * MEMORY) / INDEPENDENT, 1.0);
  for (int k = 0; k < 3; ++k)
  {
    const double signal = std::max(force_square_[k] - FORCE_NOISE * FORCE_NOISE, 0.0);
    const double slope = std::clamp(signal > 0.0 ? -product_[k] / signal : 0.0, 0.0, 1.0);
    const double left =
        std::max(thrust_square_[k] + 2.0 * slope * product_[k] + slope * slope * force_square_[k], 0.0);
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
  return slow + (1.0 - std::exp(-dt / RESPONSE)) * (now - slow);
}

}  // namespace tether_monitor::monitor
