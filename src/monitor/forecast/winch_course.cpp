#include "tether_monitor/monitor/forecast/winch_course.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double ACCELERATION = 0.25;  // with which a winch gets to another rate [m/s^2]
constexpr double FADING = 1.0;         // [s] of what is at the beginning only
}  // namespace

WinchCourse::WinchCourse(const WinchReaction& reaction, double rate, double away)
  : usual_rate_(reaction.isReady() ? reaction.slowRate() : rate), slow_rate_(usual_rate_)
{
  if (reaction.isReady())
  {
    share_ = reaction.share();
    slow_velocity_ = reaction.slowVelocity();
    beginning_ = rate - slow_rate_ - share_ * (away - slow_velocity_);
  }
}

double WinchCourse::advance(double dt, double wanted, double away)
{
  slow_velocity_ = WinchReaction::smoothed(slow_velocity_, away, dt);
  slow_rate_ += std::clamp(wanted - slow_rate_, -ACCELERATION * dt, ACCELERATION * dt);
  beginning_ *= std::exp(-dt / FADING);
  return slow_rate_ + share_ * (away - slow_velocity_) + beginning_;
}

}  // namespace tether_monitor::monitor
