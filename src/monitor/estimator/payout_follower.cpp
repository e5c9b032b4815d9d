#include "tether_monitor/monitor/estimator/payout_follower.h"

#include <cmath>
#include <limits>

#include "tether_monitor/core/cable/winch_drum.h"

namespace tether_monitor::monitor
{
PayoutFollower::PayoutFollower(const Config& config)
  : capacity_(config.winch ? core::WinchDrum(*config.winch, config.tether.diameter).capacity()
                           : std::numeric_limits<double>::infinity())
{
}

bool PayoutFollower::add(double t, double length, double rate, bool can_deploy)
{
  using Verdict = PayoutPlausibility::Verdict;
  if (!can_deploy || length > capacity_ || std::abs(rate) > PayoutBuffer::FASTEST || !buffer_.isLater(t))
    return false;
  const Verdict verdict = plausibility_.check(t, length, rate);
  if (verdict == Verdict::DOUBTFUL)
    return false;
  if (verdict == Verdict::REACQUIRED)
    buffer_.clear();
  return buffer_.add(t, length, plausibility_.trustsRate() ? rate : std::numeric_limits<double>::quiet_NaN());
}

bool PayoutFollower::addStowed(double t, double rate)
{
  if (!buffer_.isLater(t) || plausibility_.check(t, 0.0, rate) == PayoutPlausibility::Verdict::DOUBTFUL)
    return false;
  buffer_.clear();
  return true;
}

double PayoutFollower::age(double t) const
{
  return buffer_.hasReport() ? buffer_.age(t) : std::numeric_limits<double>::quiet_NaN();
}

void PayoutFollower::aim(double t, EndTargets& targets)
{
  if (!buffer_.hasReport())
    return;
  targets.payout = buffer_.blend(t);
  targets.payout_age = buffer_.age(t);
}

bool PayoutFollower::isLeap(const EndTargets& targets, double t, const CableSimulation& simulation) const
{
  if (!targets.payout)
    return false;
  const double mean = (targets.payout->length - simulation.length()) / (t - simulation.state.time);
  return std::abs(mean) > PayoutBuffer::FASTEST || std::abs(targets.payout->rate) > PayoutBuffer::FASTEST ||
         !simulation.model.canRepresentLength(targets.payout->length);
}

std::optional<core::PayoutTrajectory> PayoutFollower::trajectory(const EndTargets& targets, double t,
                                                                 const CableSimulation& simulation) const
{
  if (!targets.payout)
    return std::nullopt;
  return core::PayoutTrajectory::between(simulation.state.time, {simulation.length(), rate_, 0.0}, t,
                                         *targets.payout);
}

void PayoutFollower::reached(const EndTargets& targets)
{
  const bool is_usable = targets.payout && std::abs(targets.payout->rate) <= PayoutBuffer::FASTEST;
  rate_ = is_usable ? targets.payout->rate : 0.0;
}

}  // namespace tether_monitor::monitor
