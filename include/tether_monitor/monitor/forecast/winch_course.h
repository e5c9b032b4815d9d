#pragma once

#include "tether_monitor/monitor/forecast/winch_reaction.h"

namespace tether_monitor::monitor
{
/// The pay-out of a winch from a time on.
class WinchCourse
{
 public:
  /// @param rate,away  at the beginning, as of WinchReaction::observe(). A winch that has not been watched for
  /// long goes on at its rate.
  WinchCourse(const WinchReaction& reaction, double rate, double away);

  /// At which it goes on, waves apart, if nothing else is wanted [m/s].
  double usualRate() const { return usual_rate_; }
  /// The next step. @param wanted  rate without waves, reached as fast as a winch can [m/s].
  /// @param away  velocity of the vessel's end, as of WinchReaction::observe(). @return the rate then [m/s].
  double advance(double dt, double wanted, double away);

 private:
  double usual_rate_, slow_rate_;             // [m/s]
  double share_ = 0.0, slow_velocity_ = 0.0;  // as of the reaction
  double beginning_ = 0.0;                    // rate at the beginning that is neither slow nor of waves [m/s]
};

}  // namespace tether_monitor::monitor
