#include "tether_monitor/monitor/alarms/alarm.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double NEVER = -std::numeric_limits<double>::infinity();
constexpr double SAME = 1e-9;  // [s]
}  // namespace

Alarm::Alarm(AlarmDefinition definition) : definition_(std::move(definition))
{
  raised_.fill(NEVER);
}

AlarmCondition Alarm::condition() const
{
  return {is_past_, definition_.timing.latch, definition_.timing.manual_reset};
}

bool Alarm::apply(AlarmAction action, double t)
{
  const std::optional<AlarmState> next = nextState(state_, action, condition());
  if (!next)
    return false;
  state_ = *next;
  since_ = t;
  if (state_ != AlarmState::SHELVED)
    shelved_until_ = std::numeric_limits<double>::quiet_NaN();
  return true;
}

double Alarm::offDelay() const
{
  const AlarmTiming& timing = definition_.timing;
  return is_chattering_ ? std::max(timing.off_delay, timing.chatter_hold) : timing.off_delay;
}

void Alarm::noteRaise(double t)
{
  std::rotate(raised_.begin(), raised_.begin() + 1, raised_.end());
  raised_.back() = t;
  is_chattering_ = definition_.timing.chatter_hold > 0.0 && t - raised_.front() <= CHATTER_WINDOW;
}

// What time alone does.
bool Alarm::tend(double t)
{
  if (is_chattering_ && !is_past_ && t - raised_.back() > CHATTER_WINDOW)
    is_chattering_ = false;
  if (state_ == AlarmState::SHELVED && t >= shelved_until_)
    return apply(AlarmAction::UNSHELVE, t);
  const double realarm = definition_.timing.realarm;
  return realarm > 0.0 && state_ == AlarmState::ACKNOWLEDGED && t - since_ >= realarm &&
         apply(AlarmAction::REALARM, t);
}

bool Alarm::update(double t, double value, double s)
{
  value_ = value;
  s_ = s;
  const bool was_tended = tend(t);
  if (std::isnan(value))
  {
    // The safe side: what was past the limit may be so still, what was back may not.
    if (is_past_)
      pending_since_.reset();
    return was_tended;
  }
  const double sign = definition_.side == Side::ABOVE ? 1.0 : -1.0;
  if (is_past_ && sign * (value - peak_) > 0.0)
    peak_ = value;
  const double past = sign * (value - definition_.limit);
  const bool wants_change = is_past_ ? past < -definition_.timing.deadband : past > 0.0;
  if (!wants_change)
  {
    pending_since_.reset();
    return was_tended;
  }
  if (!pending_since_ || *pending_since_ > t)
    pending_since_ = t;
  if (t - *pending_since_ < (is_past_ ? offDelay() : definition_.timing.on_delay) - SAME)
    return was_tended;
  pending_since_.reset();
  is_past_ = !is_past_;
  if (!is_past_)
    return apply(AlarmAction::RETURN, t) || was_tended;
  onset_ = t;
  peak_ = value;
  noteRaise(t);
  return apply(AlarmAction::RAISE, t) || was_tended;
}

bool Alarm::release(double t)
{
  pending_since_.reset();
  const bool was_tended = tend(t);
  if (!is_past_)
    return was_tended;
  is_past_ = false;
  return apply(AlarmAction::RETURN, t) || was_tended;
}

bool Alarm::act(AlarmAction action, double t, double seconds)
{
  if (action == AlarmAction::SHELVE && !(seconds > 0.0 && seconds <= LONGEST_SHELVING))
    return false;
  if (!apply(action, t))
    return false;
  if (action == AlarmAction::SHELVE)
    shelved_until_ = t + seconds;
  return true;
}

bool Alarm::resetTimers(double t)
{
  pending_since_.reset();
  raised_.fill(NEVER);
  is_chattering_ = false;
  return state_ == AlarmState::SHELVED && apply(AlarmAction::UNSHELVE, t);
}

}  // namespace tether_monitor::monitor
