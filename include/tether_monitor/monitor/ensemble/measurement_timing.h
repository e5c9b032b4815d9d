#pragma once

#include <limits>

namespace tether_monitor::monitor
{
/// How often positions come, and how late: what is usual, learnt from those that came.
class MeasurementTiming
{
 public:
  /// @param latency  that every measurement has at least [s].
  explicit MeasurementTiming(double latency) : least_latency_(latency), latency_(latency) {}

  /// A position of time t [s] came. @param now  time of the last step [s]; NaN before the first.
  void add(double t, double now);
  void clear() { *this = MeasurementTiming(least_latency_); }

  /// Time of the newest position [s]; -infinity before the first.
  double newest() const { return newest_; }
  /// Usual time between positions [s]; 0 before the second.
  double interval() const { return interval_; }
  /// Time for which positions that were due have not come [s], when the last is `age` old: less latency and two of
  /// their usual intervals.
  double overdueTime(double age) const { return age - latency_ - 2.0 * interval_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(newest_, interval_, latency_);
  }

 private:
  double least_latency_;  // [s]
  double newest_ = -std::numeric_limits<double>::infinity();
  double interval_ = 0.0;
  double latency_;  // usual [s]
};

}  // namespace tether_monitor::monitor
