#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::monitor
{
/// The last thrusts that were told of a vehicle: each counts from its own time on, until the next. Plain data.
class ThrustBuffer
{
 public:
  /// Accepts a thrust from time t [s] on, body axes; one of the same time as the last takes its place, an older
  /// one comes too late.
  void add(double t, const core::Wrench& thrust)
  {
    if (count_ > 0 && t < entries_[count_ - 1].t)
      return;
    if (count_ > 0 && t == entries_[count_ - 1].t)
      --count_;
    if (count_ == CAPACITY)
    {
      for (std::size_t i = 1; i < CAPACITY; ++i)
        entries_[i - 1] = entries_[i];
      --count_;
    }
    entries_[count_++] = {t, thrust};
  }
  void clear() { count_ = 0; }

  /// That of time t [s]; none before the first.
  core::Wrench at(double t) const
  {
    for (std::size_t i = count_; i-- > 0;)
      if (entries_[i].t <= t)
        return entries_[i].thrust;
    return core::Wrench();
  }
  /// Likewise, and nothing before the first.
  std::optional<core::Wrench> reportedAt(double t) const
  {
    return count_ > 0 && entries_[0].t <= t ? std::optional<core::Wrench>(at(t)) : std::nullopt;
  }
  /// The last that was told; none before the first.
  core::Wrench latest() const { return count_ > 0 ? entries_[count_ - 1].thrust : core::Wrench(); }
  /// How old the last is at time t [s]; nothing: there is none.
  std::optional<double> age(double t) const
  {
    if (count_ == 0)
      return std::nullopt;
    const double age = t - entries_[count_ - 1].t;
    return age > 0.0 ? age : 0.0;
  }
  bool isValid() const { return count_ <= CAPACITY; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(entries_, count_);
  }

 private:
  static constexpr std::size_t CAPACITY = 64;
  struct Entry
  {
    double t = 0.0;  // [s]
    core::Wrench thrust = {};

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, thrust);
    }
  };
  std::array<Entry, CAPACITY> entries_{};  // in order of time
  std::size_t count_ = 0;
};

}  // namespace tether_monitor::monitor
