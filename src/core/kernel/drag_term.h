#pragma once

#include "added_mass_term.h"

#include "tether_monitor/core/element/morison_drag.h"

namespace tether_monitor::core::kernel
{
// Drag of the water (M9) on what is submerged, or of the wind on what is not.
template <class V>
TM_INLINE MorisonDrag<V> addDrag(const ElementConstants<V>& e, V scale, const V* flow, IntegrationPoint<V>& p)
{
  V u[3];
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    u[k] = p.velocity[k] - flow[k];
  const MorisonDrag<V> drag =
      morisonDrag(scale * e.drag_normal, scale * e.drag_tangential, u, p.t, p.inverse_square);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    p.f[k] += drag.force[k];
  return drag;
}

template <class V>
TM_INLINE MorisonDrag<V> addWaterDrag(const ElementConstants<V>& e, const WaterAtPoint<V>& water,
                                      IntegrationPoint<V>& p)
{
  return addDrag(e, e.half_rho_d * water.compressed_diameter * water.submergence.fraction, water.velocity, p);
}

template <int W, class V>
TM_INLINE MorisonDrag<V> addWindDrag(const ElementBlock& in, const ElementConstants<V>& e,
                                     const WaterAtPoint<V>& water, IntegrationPoint<V>& p)
{
  V wind[3];
  for (int k = 0; k < 3; ++k)
    wind[k] = broadcast<W>(in.around->wind[k]);
  return addDrag(e, 0.5 * in.around->air_density * e.diameter * (1.0 - water.submergence.fraction), wind, p);
}

// df/dr of drag and added mass: the rates carry the weights of damping and mass.
template <class V, EvaluationMode MODE>
TM_INLINE void setFlowTangent(const ElementBlock& in, const MorisonDrag<V>& drag, const AddedMassForce<V>& m,
                              const IntegrationPoint<V>& p, PointTangent<V, MODE>& out)
{
  const V alpha = p.weight * (in.damping * drag.alpha + in.mass * m.normal);
  const V beta = p.weight * (in.damping * drag.beta + in.mass * m.excess * p.inverse_square);
  const V gamma = p.weight * in.damping * drag.gamma;
#pragma GCC unroll 3
  for (int row = 0; row < 3; ++row)
#pragma GCC unroll 3
    for (int column = row; column < 3; ++column)
    {
      V x = beta * p.t[row] * p.t[column] + gamma * drag.normal_flow[row] * drag.normal_flow[column];
      if (row == column)
        x += alpha;
      out.f_r[packedIndex3(row, column)] = x;
    }
}

template <class V, EvaluationMode MODE>
TM_INLINE void addWindTangent(const ElementBlock& in, const MorisonDrag<V>& air, const IntegrationPoint<V>& p,
                              PointTangent<V, MODE>& out)
{
  for (int row = 0; row < 3; ++row)
    for (int column = row; column < 3; ++column)
      out.f_r[packedIndex3(row, column)] +=
          p.weight * in.damping *
          (air.beta * p.t[row] * p.t[column] + air.gamma * air.normal_flow[row] * air.normal_flow[column] +
           (row == column ? air.alpha : V{}));
}
}  // namespace tether_monitor::core::kernel
