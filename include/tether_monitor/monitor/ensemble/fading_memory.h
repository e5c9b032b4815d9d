#pragma once

#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
/// How long something has been observed without a gap, and how much an observation counts in a memory of it that
/// fades. Plain data: copy it to save it.
class FadingMemory
{
 public:
  static constexpr double LONGEST_GAP = 60.0, SHORTEST_WATCH = 10.0;  ///< [s]

  /// False if an observation at time t [s] begins anew: not later than the last, or later by a minute.
  bool isContinuedAt(double t) const { return isEmpty() || (t > time_ && t - time_ <= LONGEST_GAP); }
  /// The next observation. @return time since the last, 0 if it is the first [s].
  double advance(double t)
  {
    const double dt = isEmpty() ? 0.0 : t - time_;
    time_ = t;
    observed_for_ += isEmpty() ? FIRST : dt;
    return dt;
  }
  bool isEmpty() const { return observed_for_ == 0.0; }
  /// True once it has been observed for ten seconds.
  bool isReady() const { return observed_for_ >= SHORTEST_WATCH; }
  bool isValid() const { return std::isfinite(time_) && observed_for_ >= 0.0; }

  /// Share of the last observation in a memory [s], which was dt [s] after the one before; 1 for the first.
  double shareOfNow(double dt, double memory) const
  {
    return dt > 0.0 ? passed(dt, std::min(memory, observed_for_)) : 1.0;
  }
  /// How many errors, independent after a time [s], a memory [s] has averaged.
  double independent(double memory, double time) const
  {
    return std::max(std::min(observed_for_, 2.0 * memory) / time, 1.0);
  }
  /// How much of a change has passed a low-pass filter of a time constant [s] after dt [s].
  static double passed(double dt, double time_constant) { return 1.0 - std::exp(-dt / time_constant); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(time_, observed_for_);
  }

 private:
  static constexpr double FIRST = 1e-3;  // that the first has been observed for [s]

  double time_ = 0.0, observed_for_ = 0.0;  // [s]
};

}  // namespace tether_monitor::monitor
