#pragma once

#include <ros/time.h>

namespace tether_monitor
{
/// Turns ROS times into seconds since an epoch and back. The only place where the two meet.
class TimeOrigin
{
 public:
  TimeOrigin() = default;
  /// @param first  any time of the run; the epoch is the whole second before it.
  explicit TimeOrigin(const ros::Time& first) : epoch_(first.sec, 0) {}

  /// The epoch [s] of ROS time.
  double epoch() const { return epoch_.toSec(); }
  /// Seconds since the epoch; exact to a nanosecond within months of it.
  double seconds(const ros::Time& t) const { return (t - epoch_).toSec(); }
  /// The ROS time of `t` seconds since the epoch; times before 1970 become zero.
  ros::Time stamp(double t) const
  {
    const double whole = epoch_.toSec() + t;
    return whole > 0.0 ? epoch_ + ros::Duration(t) : ros::Time();
  }

 private:
  ros::Time epoch_;
};

}  // namespace tether_monitor
