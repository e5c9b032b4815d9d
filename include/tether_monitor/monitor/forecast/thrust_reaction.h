#pragma once

#include <array>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/monitor/ensemble/fading_memory.h"
#include "tether_monitor/monitor/forecast/fading_regression.h"

namespace tether_monitor::monitor
{
/**
 * How far a vehicle's thrust makes up for what the tether does to it: an autopilot that holds a place, a depth or
 * a speed answers the tether's force, a pilot's stick does not. Regression of the reported thrust on the tether's
 * force, axis by axis, over the last twenty seconds, (F5) of doc/theory/forecast.md. Plain data: copy it to save
 * it.
 */
class ThrustReaction
{
 public:
  static constexpr double RESPONSE = 2.0;  ///< time constant of an autopilot [s].

  /// @param thrust,tether_force  on the vehicle at time t [s], world axes [N]. A time that is not later, or later
  /// by a minute, begins anew.
  void observe(double t, const core::Vector3& thrust, const core::Vector3& tether_force);
  void clear() { *this = ThrustReaction(); }
  /// True once it has been observed for ten seconds.
  bool isReady() const { return memory_.isReady(); }
  bool isValid() const;

  /// What the thrust answers: the tether's force without waves [N].
  const core::Vector3& tetherForce() const { return slow_force_; }
  /// How much slower than the tether's force that is: less the force of the moment [N].
  core::Vector3 lag() const { return slow_force_ - force_; }
  /// The largest thrust that was reported [N].
  double largestThrust() const { return largest_; }
  /// The share of a change of the tether's force that thrust takes off again, 0 (held) to 1, of every world axis:
  /// its most probable value, and how uncertain that is.
  struct Share
  {
    core::Vector3 mean, stddev;
  };
  Share share() const;
  /// A force without waves, a time dt [s] later [N].
  static core::Vector3 smoothed(const core::Vector3& slow, const core::Vector3& now, double dt);

  template <class Archive>
  void serialize(Archive& a)
  {
    a(memory_, force_, slow_force_, axes_, largest_);
  }

 private:
  FadingMemory memory_;
  core::Vector3 force_ = core::Vector3::Zero(), slow_force_ = core::Vector3::Zero();  // [N]
  std::array<FadingRegression, 3> axes_;                                              // of thrust on force
  double largest_ = 0.0;                                                              // [N]
};

}  // namespace tether_monitor::monitor
