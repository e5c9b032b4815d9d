#pragma once

#include <optional>

namespace tether_monitor::monitor
{
/// How good the vehicle's navigation is, and how little is known of the forces on it; for OBSERVED.
struct NavigationConfig
{
  double position_stddev = 0.5;        ///< without covariance in the message [m], > 0.
  double velocity_stddev = 0.1;        ///< of velocities without covariance [m/s], > 0.
  double latency = 0.0;                ///< how much older a measurement is than its stamp [s], 0..30.
  std::optional<double> force_stddev;  ///< disturbance force [N], > 0; none: 0.16 m/s^2 times the mass.
  double drag_stddev = 0.15;           ///< of the relative error of the drag areas [-], > 0.
  double degraded_stddev = 0.15;       ///< of a tension, over the working load: DEGRADED above [-], > 0.
  double invalid_stddev = 0.5;         ///< of a tension, INVALID above; >= degraded_stddev.
};

}  // namespace tether_monitor::monitor
