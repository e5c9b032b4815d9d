#pragma once

#include "tether_monitor/monitor/vehicle/error_state_filter.h"

namespace tether_monitor::monitor
{
/// A taut tether along x that holds a vehicle of half a ton.
inline TetherLinearization springs()
{
  TetherLinearization s;
  s.mass = 500.0 * core::Matrix3::Identity();
  s.damping = core::Vector3(20000.0, 300.0, 300.0).asDiagonal();
  s.stiffness = core::Vector3(5000.0, 20.0, 60.0).asDiagonal();
  s.vessel.position = {-5000.0, 0.0, 0.0};
  s.vessel.velocity = {-20000.0, 0.0, 0.0};
  s.vehicle = s.vessel;
  return s;
}

/// A filter at the end of such a tether, with nothing measured yet.
inline VehicleErrorStateFilter started(const TetherLinearization& stiffness = springs())
{
  VehicleErrorStateFilter filter;
  filter.start(ProcessNoiseModel(), 0.09 * core::Matrix3::Identity(), 0.2, core::Vector3::Zero(),
               core::Matrix3::Zero(), core::Vector3(-100, 0, 0), stiffness);
  return filter;
}

}  // namespace tether_monitor::monitor
