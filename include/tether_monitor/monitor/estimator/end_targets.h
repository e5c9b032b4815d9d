#pragma once

#include <limits>
#include <optional>

#include "tether_monitor/core/cable/end_clamps.h"
#include "tether_monitor/core/cable/end_trajectory.h"
#include "tether_monitor/core/cable/payout_trajectory.h"

namespace tether_monitor::monitor
{
/// What drives the tether at one time, and how old the knowledge is.
struct EndTargets
{
  core::EndMotion vessel;
  core::EndMotion vehicle;                                 ///< not used in mode free.
  double vessel_age = 0.0;                                 ///< [s]
  double vehicle_age = 0.0;                                ///< [s]
  std::optional<core::PayoutState> payout = std::nullopt;  ///< deployed length and rate; none: the length stays.
  double payout_age = std::numeric_limits<double>::quiet_NaN();  ///< [s]
  core::Vector3 vessel_stddev = core::Vector3::Zero();           ///< of the vessel end's position [m].
  double vessel_error_rate = 1.0;                                ///< how fast its errors are [1/s].
  core::Vector3 vessel_velocity_stddev = core::Vector3::Zero();  ///< of a steady velocity [m/s].
  bool is_vessel_ramping_up = false;                             ///< part of its motion in waves is still to come.
  std::optional<core::Matrix3> vehicle_covariance = std::nullopt;  ///< of the vehicle's position in a start of
                                                                   ///< mode observed [m^2]; none: as configured.
  core::EndClamps clamps = {};
};

}  // namespace tether_monitor::monitor
