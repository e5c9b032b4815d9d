#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace tether_monitor
{
/// a - b [s], for any two times: ros::Duration throws beyond 68 years.
inline double secondsBetween(const ros::Time& a, const ros::Time& b)
{
  return (static_cast<double>(a.sec) - static_cast<double>(b.sec)) +
         1e-9 * (static_cast<double>(a.nsec) - static_cast<double>(b.nsec));
}

/// Turns ROS times into seconds since an epoch and back. The only place where the two meet.
class TimeOrigin
{
 public:
  TimeOrigin() = default;
  /// @param first  any time of the run; the epoch is the whole second before it.
  explicit TimeOrigin(const ros::Time& first) : epoch_(first.sec, 0) {}

  /// The epoch [s] of ROS time.
  double epoch() const { return epoch_.sec; }
  /// Seconds since the epoch; exact to a nanosecond within months of it.
  double seconds(const ros::Time& t) const { return secondsBetween(t, epoch_); }
  /// The ROS time of `t` seconds since the epoch; what ROS cannot say becomes the nearest that it can.
  ros::Time stamp(double t) const
  {
    constexpr double LAST = 4294967295.0;  // [s]
    const double floor = std::floor(t), whole = epoch_.sec + floor;
    if (!(whole >= 0.0))
      return ros::Time();
    if (whole >= LAST)
      return ros::Time(static_cast<std::uint32_t>(LAST), 999999999);
    const auto nanoseconds = static_cast<std::uint32_t>(std::min(std::round(1e9 * (t - floor)), 999999999.0));
    return ros::Time(static_cast<std::uint32_t>(whole), nanoseconds);
  }

 private:
  ros::Time epoch_;
};

}  // namespace tether_monitor
