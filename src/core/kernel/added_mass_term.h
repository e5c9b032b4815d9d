#pragma once

#include "weight_buoyancy_term.h"

namespace tether_monitor::core::kernel
{
// Added mass and the push of accelerated water (M10), both across the tether.
template <class V>
struct AddedMassForce
{
  V added;     // mass [kg/m]
  V force[3];  // before what is along the tether is taken off
  V along;     // (t . force) / |t|^2
};

template <class V>
TM_INLINE AddedMassForce<V> addAddedMass(const ElementConstants<V>& e, const WaterAtPoint<V>& water,
                                         IntegrationPoint<V>& p)
{
  AddedMassForce<V> m;
  m.added = water.displaced_mass * e.added_mass * water.submergence.fraction;
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    m.force[k] =
        m.added * (p.acceleration[k] - water.acceleration[k]) - water.submerged_mass * water.acceleration[k];
  m.along = p.inverse_square * dot(p.t, m.force);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    p.f[k] += m.force[k] - m.along * p.t[k];
  return m;
}

// The normal plane of the added mass turns with the tether: d f / d r', (row, column), before the stiffness
// weight.
template <class V>
TM_INLINE V addedMassSlopeTangent(const AddedMassForce<V>& m, const IntegrationPoint<V>& p, int row, int column)
{
  V x = -p.t[row] * (p.inverse_square * m.force[column] - 2.0 * m.along * p.inverse_square * p.t[column]);
  if (row == column)
    x -= m.along;
  return x;
}
}  // namespace tether_monitor::core::kernel
