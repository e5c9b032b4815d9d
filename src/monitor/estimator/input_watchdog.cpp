#include "tether_monitor/monitor/estimator/input_watchdog.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
Reason late(const TetherEstimate& ages, bool coasting, double timeout)
{
  if (ages.vessel_age > timeout)
    return Reason::VESSEL_STALE;
  if (ages.vehicle_overdue > timeout && !coasting)
    return Reason::VEHICLE_STALE;
  return ages.payout_age > timeout ? Reason::PAYOUT_STALE : Reason::NONE;
}
}  // namespace

Reason InputWatchdog::invalidReason(const TetherEstimate& ages, bool coasting) const
{
  if (!std::isfinite(ages.vessel_age) || !std::isfinite(ages.vehicle_age))
    return Reason::NO_INPUT;
  return late(ages, coasting, invalid_timeout_);
}

Reason InputWatchdog::lateReason(const TetherEstimate& ages, bool coasting) const
{
  return late(ages, coasting, pose_timeout_);
}

bool InputWatchdog::hasRejectedInput(double t) const
{
  const double since = t - rejected_at_;
  return since >= 0.0 && since <= pose_timeout_;
}

}  // namespace tether_monitor::monitor
