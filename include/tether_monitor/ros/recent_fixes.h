#pragma once

#include <cstddef>

#include "tether_monitor/monitor/measurements/measurements.h"
#include "tether_monitor/monitor/measurements/ring_buffer.h"

namespace tether_monitor
{
/**
 * The last measured positions of the vehicle as they came, for those who look at them: at most two a second, so
 * that they reach half a minute back. Allocates nothing.
 */
class RecentFixes
{
 public:
  struct Fix
  {
    double t = 0.0;        ///< [s]
    core::Vector3 place;   ///< [m]; NaN along an axis that was not measured.
    core::Vector3 stddev;  ///< [m]; 0 along an axis whose accuracy was not told.
  };
  static constexpr std::size_t MOST = 60;
  static constexpr double SPACING = 0.5;  ///< [s]
  static constexpr double MEMORY = 30.0;  ///< [s]

  /// One without a horizontal place, or too soon after the one before, is left out.
  void add(const monitor::PoseMeasurement& pose);
  void clear() { fixes_.clear(); }

  /// Calls use(fix) for each that is at most MEMORY old at time t [s] and not of the time after, oldest first.
  template <typename Use>
  void forEach(double t, const Use& use) const
  {
    for (std::size_t k = 0; k < fixes_.size(); ++k)
      if (t - fixes_[k].t <= MEMORY && fixes_[k].t <= t)
        use(fixes_[k]);
  }

 private:
  monitor::RingBuffer<Fix> fixes_{MOST};
};

}  // namespace tether_monitor
