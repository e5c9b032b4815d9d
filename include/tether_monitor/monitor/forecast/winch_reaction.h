#pragma once

#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/monitor/ensemble/fading_memory.h"
#include "tether_monitor/monitor/forecast/fading_regression.h"

namespace tether_monitor::monitor
{
/**
 * How a winch works: at which rate without waves, and how far it follows the vessel's end in them. Regression of
 * the pay-out rate on the velocity of the vessel's end over the last twenty seconds, (F6) of
 * doc/theory/forecast.md. Plain data: copy it to save it.
 */
class WinchReaction
{
 public:
  /// @param rate  of pay-out at time t [s], [m/s]. @param away  velocity of the vessel's end along the tether,
  /// away from it [m/s]. A time that is not later, or later by a minute, begins anew.
  void observe(double t, double rate, double away);
  void clear() { *this = WinchReaction(); }
  /// True once it has been observed for ten seconds.
  bool isReady() const { return memory_.isReady(); }
  bool isValid() const;

  /// Pay-out per velocity of the vessel's end, 0 (a winch that follows no waves) to LARGEST_SHARE [-].
  double share() const;
  /// Rate of pay-out without waves [m/s].
  double slowRate() const { return slow_rate_; }
  /// Velocity of the vessel's end without waves, as away in observe() [m/s].
  double slowVelocity() const { return regression_.meanX(); }
  /// A velocity without waves, a time dt [s] later [m/s].
  static double smoothed(double slow, double now, double dt);

  /// Of an end at the vessel that moves with a velocity [m/s]: along its tether, away from it [m/s].
  static double away(const core::CableState& state, const core::Vector3& velocity);

  static constexpr double LARGEST_SHARE = 1.2;  ///< 1: it makes up for the waves; more is a lead.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(memory_, regression_, slow_rate_, fluctuation_);
  }

 private:
  FadingMemory memory_;
  FadingRegression regression_;  // of the rate on the velocity
  double slow_rate_ = 0.0;       // [m/s]
  double fluctuation_ = 0.0;     // mean square of the rest about it [m^2/s^2]
};

}  // namespace tether_monitor::monitor
