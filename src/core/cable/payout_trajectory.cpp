#include "tether_monitor/core/cable/payout_trajectory.h"

namespace tether_monitor::core
{
PayoutTrajectory PayoutTrajectory::constant(double length)
{
  PayoutTrajectory path;
  path.c_[0] = length;
  return path;
}

PayoutTrajectory PayoutTrajectory::between(double t0, const PayoutState& from, double t1, const PayoutState& to)
{
  const double T = t1 - t0;
  const double mean = (to.length - from.length) / T;
  PayoutTrajectory path;
  path.constant_ = from.length == to.length && from.rate == 0.0 && to.rate == 0.0;
  path.t0_ = t0;
  path.c_[0] = from.length;
  path.c_[1] = from.rate;
  path.c_[2] = (3.0 * mean - 2.0 * from.rate - to.rate) / T;
  path.c_[3] = (from.rate + to.rate - 2.0 * mean) / (T * T);
  return path;
}

PayoutState PayoutTrajectory::at(double t) const
{
  if (constant_)
    return {c_[0], 0.0, 0.0};
  const double x = t - t0_;
  return {c_[0] + x * (c_[1] + x * (c_[2] + x * c_[3])), c_[1] + x * (2.0 * c_[2] + 3.0 * x * c_[3]),
          2.0 * c_[2] + 6.0 * x * c_[3]};
}

}  // namespace tether_monitor::core
