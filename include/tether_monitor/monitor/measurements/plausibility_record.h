#pragma once

#include <array>
#include <limits>

#include "tether_monitor/monitor/measurements/implausibility.h"

namespace tether_monitor::monitor
{
/// When each kind of implausibility was last seen of each input.
class PlausibilityRecord
{
 public:
  PlausibilityRecord() { clear(); }

  void note(Subject subject, Implausibility what, double t) { seen(subject, what) = t; }
  void clear() { last_.fill(-std::numeric_limits<double>::infinity()); }
  /// When it was last seen [s]; -infinity: never.
  double last(Subject subject, Implausibility what) const { return last_[index(subject, what)]; }
  /// True if anything was seen within `memory` [s] before time t [s].
  bool hasAny(double t, double memory) const
  {
    for (const double last : last_)
      if (t - last <= memory)
        return true;
    return false;
  }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(last_);
  }

 private:
  static constexpr std::size_t KINDS = static_cast<std::size_t>(Implausibility::COUNT);
  static constexpr std::size_t index(Subject subject, Implausibility what)
  {
    return KINDS * static_cast<std::size_t>(subject) + static_cast<std::size_t>(what);
  }
  double& seen(Subject subject, Implausibility what) { return last_[index(subject, what)]; }

  std::array<double, KINDS* static_cast<std::size_t>(Subject::COUNT)> last_;
};

}  // namespace tether_monitor::monitor
