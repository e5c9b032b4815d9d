#include "tether_monitor/monitor/estimator/payout_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/cable/winch_drum.h"

namespace tether_monitor::monitor
{
namespace
{
// Of a target that reports, and what they correct, have put ahead of a winch: it is followed as fast as a winch
// can.
constexpr double LEAP = 1.0;      // [m]
constexpr double CATCH_UP = 2.0;  // so many times as fast as a winch may the tether follow

double possibleRate(double rate)
{
  return std::clamp(rate, -PayoutBuffer::FASTEST, PayoutBuffer::FASTEST);
}

core::PayoutState reachable(const core::PayoutState& target, double t, const CableSimulation& simulation)
{
  const double most = CATCH_UP * PayoutBuffer::FASTEST * (t - simulation.state.time), now = simulation.length();
  core::PayoutState state = target;
  state.length = std::clamp(state.length, now - most, now + most);
  state.rate = possibleRate(state.rate);
  return state;
}
}  // namespace

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
  const double apart = std::abs(targets.payout->length - simulation.length());
  return apart > PayoutBuffer::FASTEST * (t - simulation.state.time) + LEAP ||
         !simulation.model.canRepresentLength(targets.payout->length);
}

std::optional<core::PayoutTrajectory> PayoutFollower::trajectory(const EndTargets& targets, double t,
                                                                 const CableSimulation& simulation) const
{
  if (!targets.payout)
    return std::nullopt;
  return core::PayoutTrajectory::between(simulation.state.time, {simulation.length(), rate_, 0.0}, t,
                                         reachable(*targets.payout, t, simulation));
}

void PayoutFollower::reached(const EndTargets& targets)
{
  rate_ = targets.payout ? possibleRate(targets.payout->rate) : 0.0;
}

}  // namespace tether_monitor::monitor
