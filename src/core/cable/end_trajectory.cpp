#include "tether_monitor/core/cable/end_trajectory.h"

namespace tether_monitor::core
{
EndTrajectory EndTrajectory::between(double t0, const EndMotion& from, double t1, const EndMotion& to)
{
  const double T = t1 - t0;
  const Vector3 mean = (to.position - from.position) / T;
  EndTrajectory path;
  path.t0_ = t0;
  path.c_.col(0) = from.position;
  path.c_.col(1) = from.velocity;
  path.c_.col(2) = (3.0 * mean - 2.0 * from.velocity - to.velocity) / T;
  path.c_.col(3) = (from.velocity + to.velocity - 2.0 * mean) / (T * T);
  return path;
}

EndTrajectory EndTrajectory::uniform(double t0, const EndMotion& point)
{
  EndTrajectory path;
  path.t0_ = t0;
  path.c_.col(0) = point.position;
  path.c_.col(1) = point.velocity;
  return path;
}

Vector3 EndTrajectory::position(double t) const
{
  const double x = t - t0_;
  return c_.col(0) + x * (c_.col(1) + x * (c_.col(2) + x * c_.col(3)));
}

Vector3 EndTrajectory::velocity(double t) const
{
  const double x = t - t0_;
  return c_.col(1) + x * (2.0 * c_.col(2) + 3.0 * x * c_.col(3));
}

Vector3 EndTrajectory::acceleration(double t) const
{
  return 2.0 * c_.col(2) + 6.0 * (t - t0_) * c_.col(3);
}

}  // namespace tether_monitor::core
