#pragma once

#include <optional>

#include "tether_monitor/core/cable/payout_trajectory.h"
#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimator/end_targets.h"
#include "tether_monitor/monitor/measurements/payout_buffer.h"
#include "tether_monitor/monitor/measurements/payout_plausibility.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// Pays the tether out as the winch reports it.
class PayoutFollower
{
 public:
  explicit PayoutFollower(const Config& config);

  /// Accepts a report. @param can_deploy  the tether can be meshed with this length.
  /// @return false, and it is not used, if the winch or the clock cannot have made it. A rate that contradicts the
  /// lengths is left out.
  bool add(double t, double length, double rate, bool can_deploy);
  /// The same of a report that nothing is out. @return false if it cannot be, or not yet be believed.
  bool addStowed(double t, double rate);
  void clear()
  {
    buffer_.clear();
    plausibility_.clear();
  }
  const PayoutPlausibility& plausibility() const { return plausibility_; }
  /// Age of the last report at time t [s]; NaN if nothing reports.
  double age(double t) const;
  /// Length and rate at time t [s], if reported. Calls in order of t.
  void aim(double t, EndTargets& targets);

  /// True if the target's length at time t [s] is farther from the simulation's than any winch, and what reports
  /// correct, make it.
  bool isLeap(const EndTargets& targets, double t, const CableSimulation& simulation) const;
  /// From the simulation's length towards the target's at time t [s], as far as a winch gets; none: the length
  /// stays.
  std::optional<core::PayoutTrajectory> trajectory(const EndTargets& targets, double t,
                                                   const CableSimulation& simulation) const;
  /// The simulation has come to the target, or begins there.
  void reached(const EndTargets& targets);
  /// Rate with which the simulation pays out [m/s].
  double rate() const { return rate_; }
  bool isValid() const { return buffer_.isValid(); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(buffer_, rate_, plausibility_);
  }

 private:
  double capacity_;  // of the winch [m]; infinite without one
  PayoutBuffer buffer_;
  PayoutPlausibility plausibility_;
  double rate_ = 0.0;
};

}  // namespace tether_monitor::monitor
