#pragma once

#include <limits>
#include <optional>

#include "tether_monitor/monitor/measurements/rejection.h"

namespace tether_monitor::monitor
{
/// Heights of a body that are measured by themselves, by a depth sensor or a heave sensor, for positions that come
/// without one. Plain data.
class HeightRecord
{
 public:
  /// Accepts a height at time t [s].
  Rejection add(double t, double height);
  /// What add() would answer; nothing changes.
  Rejection check(double t, double height) const;
  /// The height at time t [s], on the straight line through the last two; none if the last one is farther from t
  /// than `reach` [s].
  std::optional<double> at(double t, double reach) const;
  void clear() { *this = HeightRecord(); }
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(last_.t, last_.height, before_.t, before_.height);
  }

 private:
  struct Sample
  {
    double t = -std::numeric_limits<double>::infinity(), height = 0.0;
  };
  Sample last_, before_;
};

}  // namespace tether_monitor::monitor
