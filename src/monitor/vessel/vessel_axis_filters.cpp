#include "tether_monitor/monitor/vessel/vessel_axis_filters.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double GATE = 6.0;             // standard deviations: farther is an outlier
constexpr int RESET_COUNT = 4;           // so many outliers in a row are the truth
constexpr double FASTEST_VESSEL = 20.0;  // [m/s]
constexpr double ACCELERATION_STDDEV = 0.015,
                 VERTICAL_ACCELERATION_STDDEV = 0.001;  // acceleration of the track, across and up [m/s^2]
}  // namespace

VesselAxisFilters::VesselAxisFilters()
  : axes{AxisKalmanFilter(ACCELERATION_STDDEV), AxisKalmanFilter(ACCELERATION_STDDEV),
         AxisKalmanFilter(VERTICAL_ACCELERATION_STDDEV)}
{
}

void VesselAxisFilters::apply(const VesselMeasurement& measured)
{
  for (int i = 0; i < 3; ++i)
  {
    AxisKalmanFilter& filter = axes[i];
    if (!std::isfinite(measured.stddev[i]))
      continue;
    if (!filter.isStarted() || measured.t - filter.time() > LONGEST_GAP)
    {
      if (!measured.is_velocity)
        filter.start(measured.t, measured.value[i], measured.stddev[i], 0.0, INITIAL_VELOCITY_STDDEV);
      continue;
    }
    filter.predict(measured.t);
    if (measured.is_velocity)
      correctVelocity(i, measured);
    else
      correctPosition(i, measured);
  }
}

void VesselAxisFilters::correctVelocity(int i, const VesselMeasurement& measured)
{
  const bool is_good =
      std::abs(axes[i].normalizedVelocityInnovation(measured.value[i], measured.stddev[i])) < GATE;
  if (is_good)
    axes[i].correctVelocity(measured.value[i], measured.stddev[i]);
  outliers += is_good ? 0 : 1;
}

void VesselAxisFilters::correctPosition(int i, const VesselMeasurement& measured)
{
  AxisKalmanFilter& filter = axes[i];
  const double innovation = filter.normalizedInnovation(measured.value[i], measured.stddev[i]);
  if (std::abs(innovation) < GATE)
  {
    consecutive_outliers[i] = 0;
    filter.correctPosition(measured.value[i], measured.stddev[i]);
  }
  else if (++consecutive_outliers[i] >= RESET_COUNT)
  {
    consecutive_outliers[i] = 0;
    filter.recordInnovation(innovation);
    const double velocity = filter.at(measured.t).velocity;
    const bool is_usable = std::abs(velocity) < FASTEST_VESSEL;
    filter.start(measured.t, measured.value[i], measured.stddev[i], is_usable ? velocity : 0.0,
                 is_usable ? 1.0 : INITIAL_VELOCITY_STDDEV);
  }
  else
  {
    ++outliers;
    if (consecutive_outliers[i] > 1)
      filter.recordInnovation(innovation);
  }
}

}  // namespace tether_monitor::monitor
