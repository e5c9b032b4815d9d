#pragma once

#include <optional>

#include "tether_monitor/core/cable/end_clamps.h"
#include "tether_monitor/core/cable/end_trajectory.h"
#include "tether_monitor/core/cable/payout_trajectory.h"

namespace tether_monitor::core
{
/// What drives a tether over a stretch of time: paths of held ends, thrust of simulated bodies, pay-out.
struct BoundaryConditions
{
  EndTrajectory vessel;
  EndTrajectory vehicle;
  Wrench vessel_thrust = {};                ///< at the centre of mass, body axes; for an end with a body.
  Wrench vehicle_thrust = {};               ///< likewise.
  Vector3 vehicle_force = Vector3::Zero();  ///< more force on a simulated vehicle [N], world axes.
  EndClamps clamps = {};
  std::optional<PayoutTrajectory> payout = std::nullopt;  ///< none: the deployed length stays.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(vessel, vehicle, vessel_thrust, vehicle_thrust, vehicle_force, clamps, payout);
  }
};

}  // namespace tether_monitor::core
