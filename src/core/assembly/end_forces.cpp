#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::core
{
EndForces endForces(const DeployedCable& cable, const CableState& state)
{
  std::array<ElementCoords, kernel::BLOCK> parts;
  EndForces ends;
  cable.elementResiduals(0, state, parts);
  ends.vessel = -parts[0].segment<3>(0);  // (M13)
  const int last = (cable.elements() - 1) / kernel::BLOCK * kernel::BLOCK;
  const int count = cable.elementResiduals(last, state, parts);
  ends.vehicle = -parts[count - 1].segment<3>(6);
  setClampMoments(cable, state, ends);
  return ends;
}

void setClampMoments(const DeployedCable& cable, const CableState& state, EndForces& ends)
{
  ends.vessel_moment = cable.vesselClamp(state).moment(state.q.front().tail<3>());
  ends.vehicle_moment = cable.vehicleClamp(state).moment(state.q.back().tail<3>());
}

EndForces endForces(const CableModel& model, const CableState& state)
{
  return endForces(DeployedCable(model, state.deployment), state);
}

}  // namespace tether_monitor::core
