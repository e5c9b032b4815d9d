#pragma once

#include "tether_monitor/core/assembly/deployed_cable.h"

namespace tether_monitor::core
{
/// Forces exerted by the tether on what holds its ends, world frame [N].
struct EndForces
{
  Vector3 vessel = Vector3::Zero();
  Vector3 vehicle = Vector3::Zero();
  Vector3 vessel_moment = Vector3::Zero();   ///< of a clamped end, about it [N m].
  Vector3 vehicle_moment = Vector3::Zero();  ///< likewise.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(vessel, vehicle, vessel_moment, vehicle_moment);
  }
};

/// End forces as the residual of the equations of motion at both ends, (M13) of doc/model.md: they contain weight,
/// drag and inertia of the tether, and are far more accurate than EA eps there.
EndForces endForces(const DeployedCable& cable, const CableState& state);
/// Sets the moments of both ends, zero where they are hinged, and nothing else.
void setClampMoments(const DeployedCable& cable, const CableState& state, EndForces& ends);
/// The end forces for set-up and tests: allocates.
EndForces endForces(const CableModel& model, const CableState& state);

}  // namespace tether_monitor::core
