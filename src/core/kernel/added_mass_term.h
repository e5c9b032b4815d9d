#pragma once

#include "weight_buoyancy_term.h"

namespace tether_monitor::core::kernel
{
// Added mass (M10): of the motion across the tether and of that along it, relative to the water.
template <class V>
struct AddedMassForce
{
  V normal;       // mass [kg/m]
  V excess;       // what the mass along the tether has more than that across it [kg/m]
  V relative[3];  // acceleration in the water [m/s^2]
  V along;        // (t . relative) / |t|^2
};

template <class V>
TM_INLINE AddedMassForce<V> addAddedMass(const ElementConstants<V>& e, const WaterAtPoint<V>& water,
                                         IntegrationPoint<V>& p)
{
  AddedMassForce<V> m;
  m.normal = water.submerged_mass * e.added_mass;
  m.excess = water.submerged_mass * (e.added_mass_tangential - e.added_mass);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    m.relative[k] = p.acceleration[k] - water.acceleration[k];
  m.along = p.inverse_square * dot(p.t, m.relative);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    p.f[k] += m.normal * m.relative[k] + m.excess * m.along * p.t[k];
  return m;
}

// The axes of the added mass turn with the tether: d f / d r', (row, column), before the stiffness weight.
template <class V>
TM_INLINE V addedMassSlopeTangent(const AddedMassForce<V>& m, const IntegrationPoint<V>& p, int row, int column)
{
  V x = p.t[row] * p.inverse_square * (m.relative[column] - 2.0 * m.along * p.t[column]);
  if (row == column)
    x += m.along;
  return m.excess * x;
}
}  // namespace tether_monitor::core::kernel
