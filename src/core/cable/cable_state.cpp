#include "tether_monitor/core/cable/cable_state.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
CableState::CableState(double t, const NodeField& shape, const Vector3& V, const Deployment& deployed)
  : time(t), deployment(deployed), q(shape), v(shape.size(), NodeCoords::Zero()), a(v), algorithmic_acceleration(v)
{
  for (NodeCoords& rate : v)
    rate.head<3>() = V;
}

bool CableState::allFinite() const
{
  const auto finite = [](const NodeField& field)
  { return std::all_of(field.begin(), field.end(), [](const NodeCoords& x) { return x.allFinite(); }); };
  return std::isfinite(time) && finite(q) && finite(v) && finite(a) && finite(algorithmic_acceleration);
}

}  // namespace tether_monitor::core
