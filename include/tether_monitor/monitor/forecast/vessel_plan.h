#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::monitor
{
/// Where a vessel is meant to go. A forecast takes its velocities: the vessel begins where it is.
class VesselPlan
{
 public:
  static constexpr std::size_t MOST_POINTS = 1000;

  struct Point
  {
    double t = 0.0;                                  ///< [s]
    core::Vector3 position = core::Vector3::Zero();  ///< world [m].

    template <class Archive>
    void serialize(Archive& a)
    {
      a(t, position);
    }
  };

  /// Replaces the plan; none: there is no plan any more. @return why it cannot be, and nothing changes: times that
  /// do not increase, a speed above 50 m/s, a single point, too many. Empty: it was taken.
  std::string set(const std::vector<Point>& points);
  bool isEmpty() const { return points_.empty(); }
  /// Horizontal velocity that is planned for time t [s]; nothing before and after the plan.
  std::optional<core::Vector3> velocity(double t) const;
  bool isValid() const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(points_);
  }

 private:
  std::vector<Point> points_;
};

/// What a winch is meant to do: from a time on, at a rate, to a length.
struct PayoutPlan
{
  double t = 0.0;       ///< [s]
  double length = 0.0;  ///< at which it stops [m]; NaN: nowhere.
  double rate = 0.0;    ///< [m/s]; only its size counts where there is a length.

  /// Rate at time `now` [s] with `deployed` out [m]; `present` [m/s] before the plan begins.
  double rateAt(double now, double deployed, double present) const;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t, length, rate);
  }
};

}  // namespace tether_monitor::monitor
