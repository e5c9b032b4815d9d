#include "tether_monitor/monitor/alarms/alarm.h"

#include <cmath>

namespace tether_monitor::monitor
{
void Alarm::enter(AlarmState state, double t)
{
  state_ = state;
  since_ = t;
  pending_since_.reset();
}

bool Alarm::update(double t, double value, double s)
{
  value_ = value;
  s_ = s;
  if (std::isnan(value))
  {
    // The safe side: what was past the limit may be so still, what was back may not.
    if (isActive())
      pending_since_.reset();
    return false;
  }
  const double sign = definition_.side == Side::ABOVE ? 1.0 : -1.0;
  if (isActive() && sign * (value - peak_) > 0.0)
    peak_ = value;
  const double past = sign * (value - definition_.limit);
  const bool wants_change = isActive() ? past < -definition_.timing.deadband : past > 0.0;
  if (!wants_change)
  {
    pending_since_.reset();
    return false;
  }
  if (!pending_since_ || *pending_since_ > t)
    pending_since_ = t;
  const double delay = isActive() ? definition_.timing.off_delay : definition_.timing.on_delay;
  if (t - *pending_since_ < delay - 1e-9)
    return false;
  if (!isActive())
  {
    enter(AlarmState::UNACKNOWLEDGED, t);
    onset_ = t;
    peak_ = value;
  }
  else if (state_ == AlarmState::UNACKNOWLEDGED && definition_.timing.latch)
    enter(AlarmState::RETURNED_UNACKNOWLEDGED, t);
  else
    enter(AlarmState::NORMAL, t);
  return true;
}

bool Alarm::release(double t)
{
  pending_since_.reset();
  if (!isActive())
    return false;
  const bool latches = state_ == AlarmState::UNACKNOWLEDGED && definition_.timing.latch;
  enter(latches ? AlarmState::RETURNED_UNACKNOWLEDGED : AlarmState::NORMAL, t);
  return true;
}

bool Alarm::acknowledge(double t)
{
  if (state_ == AlarmState::UNACKNOWLEDGED)
  {
    const std::optional<double> pending = pending_since_;
    enter(AlarmState::ACKNOWLEDGED, t);
    pending_since_ = pending;
    return true;
  }
  if (state_ == AlarmState::RETURNED_UNACKNOWLEDGED)
  {
    enter(AlarmState::NORMAL, t);
    return true;
  }
  return false;
}

void Alarm::resetTimers()
{
  pending_since_.reset();
}

}  // namespace tether_monitor::monitor
