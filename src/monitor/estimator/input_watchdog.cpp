#include "tether_monitor/monitor/estimator/input_watchdog.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
ReasonSet late(const TetherEstimate& ages, bool coasting, double timeout)
{
  ReasonSet reasons;
  if (ages.vessel_age > timeout)
    reasons.add(Reason::VESSEL_STALE);
  if (ages.vehicle_overdue > timeout && !coasting)
    reasons.add(Reason::VEHICLE_STALE);
  if (ages.payout_age > timeout)
    reasons.add(Reason::PAYOUT_STALE);
  return reasons;
}
}  // namespace

ReasonSet InputWatchdog::invalidReasons(const TetherEstimate& ages, bool coasting) const
{
  ReasonSet reasons = late(ages, coasting, invalid_timeout_);
  if (!std::isfinite(ages.vessel_age) || !std::isfinite(ages.vehicle_age))
    reasons.add(Reason::NO_INPUT);
  return reasons;
}

ReasonSet InputWatchdog::lateReasons(const TetherEstimate& ages, bool coasting) const
{
  return late(ages, coasting, pose_timeout_);
}

bool InputWatchdog::hasRejectedInput(double t) const
{
  const double since = t - rejected_at_;
  return since >= 0.0 && since <= pose_timeout_;
}

}  // namespace tether_monitor::monitor
