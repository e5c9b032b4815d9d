#pragma once

#include <array>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/monitor/vessel/axis_kalman_filter.h"

namespace tether_monitor::monitor
{
/// A position [m] or velocity [m/s] of the vessel's end at its own time.
struct VesselMeasurement
{
  double t = 0.0;  ///< [s]
  bool is_velocity = false;
  core::Vector3 value = core::Vector3::Zero();
  core::Vector3 stddev = core::Vector3::Zero();  ///< infinite: not measured; 0: not known yet.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(t, is_velocity, value, stddev);
  }
};

/**
 * The filters of the three axes of the vessel's end after some measurements: outliers are left out, until there
 * have been so many of them that they are the truth. Plain data: copy it to save it.
 */
struct VesselAxisFilters
{
  static constexpr double LONGEST_GAP = 60.0;             ///< [s]; after it a filter begins anew.
  static constexpr double INITIAL_VELOCITY_STDDEV = 5.0;  ///< of an unknown velocity [m/s].

  VesselAxisFilters();

  /// Accepts a measurement; in order of time.
  void apply(const VesselMeasurement& measured);

  std::array<AxisKalmanFilter, 3> axes;
  std::array<int, 3> consecutive_outliers{};
  long outliers = 0;

  template <class Archive>
  void serialize(Archive& a)
  {
    a(axes, consecutive_outliers, outliers);
  }

 private:
  void correctPosition(int i, const VesselMeasurement& measured);
  void correctVelocity(int i, const VesselMeasurement& measured);
};

}  // namespace tether_monitor::monitor
