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
  /// How long a place or length is doubted that an input has leapt to [s].
  static constexpr double DOUBT = 60.0;

  PlausibilityRecord() { clear(); }

  void note(Subject subject, Implausibility what, double t) { seen(subject, what) = t; }
  void clear() { last_.fill(-std::numeric_limits<double>::infinity()); }
  /// When it was last seen [s]; -infinity: never.
  double last(Subject subject, Implausibility what) const { return last_[index(subject, what)]; }
  /// True if this is still to be minded at time t [s]. @param memory  how long the tether remembers [s].
  bool holds(Subject subject, Implausibility what, double t, double memory) const
  {
    const bool is_doubt = what == Implausibility::RELOCATION || what == Implausibility::OTHER_LENGTH;
    return t - last(subject, what) <= (is_doubt ? DOUBT : memory);
  }
  /// The same of anything.
  bool holdsAny(double t, double memory) const
  {
    for (int s = 0; s < static_cast<int>(Subject::COUNT); ++s)
      for (int k = 0; k < static_cast<int>(Implausibility::COUNT); ++k)
        if (holds(static_cast<Subject>(s), static_cast<Implausibility>(k), t, memory))
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
