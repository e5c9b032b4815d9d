#pragma once

#include <limits>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor::monitor
{
/// Watches the ages of the inputs and what had to be refused of them.
class InputWatchdog
{
 public:
  explicit InputWatchdog(const Config& config)
    : pose_timeout_(config.pose_timeout), invalid_timeout_(config.invalid_timeout)
  {
  }

  /// A measurement had to be refused at time t [s].
  void noteRejectedInput(double t) { rejected_at_ = t; }
  void clear() { rejected_at_ = -std::numeric_limits<double>::infinity(); }

  /// What makes an estimate with these ages impossible; empty if nothing does. @param coasting  the vehicle's may
  /// be late.
  ReasonSet invalidReasons(const TetherEstimate& ages, bool coasting) const;
  /// What makes it doubtful because an input is late.
  ReasonSet lateReasons(const TetherEstimate& ages, bool coasting) const;
  /// True for a pose_timeout after a refusal.
  bool hasRejectedInput(double t) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(rejected_at_);
  }

 private:
  double pose_timeout_, invalid_timeout_;  // [s]
  double rejected_at_ = -std::numeric_limits<double>::infinity();
};

}  // namespace tether_monitor::monitor
