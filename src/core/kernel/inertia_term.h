#pragma once

#include "integration_point.h"

#include "tether_monitor/core/element/unit_matrices.h"

namespace tether_monitor::core::kernel
{
// Consistent mass (M7): linear in the accelerations.
template <class V>
TM_INLINE V inertiaEntry(V mass, int i, int j)
{
  return mass * (UNIT_MASS[i][j] / UNIT_MASS_DIVISOR);
}

template <class V>
TM_INLINE void setInertia(V mass, const Coords<V>& a, V (&R)[4][3])
{
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i)
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      R[i][k] = inertiaEntry(mass, i, 0) * a.x[0][k] + inertiaEntry(mass, i, 1) * a.x[1][k] +
                inertiaEntry(mass, i, 2) * a.x[2][k] + inertiaEntry(mass, i, 3) * a.x[3][k];
}
}  // namespace tether_monitor::core::kernel
