#include "tether_monitor/monitor/estimator/tracked_vessel_end.h"

namespace tether_monitor::monitor
{
void TrackedVesselEnd::aim(double t, EndTargets& targets)
{
  targets.vessel = body_.attachmentMotion(t);
  targets.clamps.vessel = body_.clampDirection(t);
  targets.vessel_age = age(t);
  targets.vessel_stddev.setConstant(body_.plausibility().measuredScatter());
}

}  // namespace tether_monitor::monitor
