#include "tether_monitor/ros/recent_fixes.h"

#include <cmath>
#include <limits>

namespace tether_monitor
{
void RecentFixes::add(const monitor::PoseMeasurement& pose)
{
  const monitor::MeasuredVector& measured = pose.position;
  if (!measured.isMeasured(0) || !measured.isMeasured(1))
    return;
  if (!fixes_.empty() && std::abs(pose.t - fixes_.back().t) < SPACING)
    return;
  Fix& fix = fixes_.emplaceBack();
  fix.t = pose.t;
  fix.place = measured.value();
  for (int axis = 0; axis < 3; ++axis)
    fix.stddev[axis] = measured.accuracy(axis) == monitor::Accuracy::SPECIFIED ? measured.stddev(axis) : 0.0;
  if (!measured.isMeasured(2))
    fix.place.z() = std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tether_monitor
