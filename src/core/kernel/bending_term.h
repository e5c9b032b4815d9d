#pragma once

#include "integration_point.h"

#include "tether_monitor/core/element/unit_matrices.h"

namespace tether_monitor::core::kernel
{
// Bending (M6): linear in the coordinates; a translation costs nothing, exactly.
template <class V>
TM_INLINE void addBending(V stiffness, const Coords<V>& q, V (&R)[4][3])
{
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i)
#pragma GCC unroll 3
    for (int k = 0; k < 3; ++k)
      R[i][k] += stiffness * (UNIT_BENDING[i][2] * (q.x[2][k] - q.x[0][k]) + UNIT_BENDING[i][1] * q.x[1][k] +
                              UNIT_BENDING[i][3] * q.x[3][k]);
}
}  // namespace tether_monitor::core::kernel
