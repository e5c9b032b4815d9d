#pragma once

#include "integration_point.h"

namespace tether_monitor::core::kernel
{
// The tether slides through the mesh (M24): material rates from those of the mesh, and what its inertia needs
// more.
template <int W, class V>
TM_INLINE void addPayoutFlow(int g, const ElementBlock& in, int first, const ElementConstants<V>& e,
                             const Coords<V>& q, const Coords<V>& v, IntegrationPoint<V>& p)
{
  const V growth = constant<W>(in, first, TRANSPORT_GROWTH);
  const V speed_a = constant<W>(in, first, TRANSPORT_SPEED_A), rate_a = constant<W>(in, first, TRANSPORT_RATE_A);
  const V speed = speed_a + HERMITE.xi[g] * (constant<W>(in, first, TRANSPORT_SPEED_B) - speed_a);
  const V speed_rate = rate_a + HERMITE.xi[g] * (constant<W>(in, first, TRANSPORT_RATE_B) - rate_a);
  p.transport_speed = speed;
  for (int k = 0; k < 3; ++k)
  {
    const V spread_slope = slopesAlone(HERMITE.N[g], q, k);
    const V turn = p.rate[k] + growth * (e.inverse_length * slopesAlone(HERMITE.dN[g], q, k) - p.t[k]);
    const V curvature = e.inverse_length * e.inverse_length * slopeAt(HERMITE.ddN[g], q, k);
    const V extra = 2.0 * growth * slopesAlone(HERMITE.N[g], v, k) +
                    constant<W>(in, first, TRANSPORT_ACCELERATION) * spread_slope + speed_rate * p.t[k] +
                    2.0 * speed * turn + speed * speed * curvature;
    p.velocity[k] += growth * spread_slope + speed * p.t[k];
    p.rate[k] = turn + speed * curvature;
    p.acceleration[k] += extra;
    p.f[k] = e.mass * extra;
  }
}

// The part of it in the tangent of the loads with the slope.
template <class V, EvaluationMode MODE>
TM_INLINE void addPayoutFlowTangent(const ElementBlock& in, const ElementConstants<V>& e,
                                    const IntegrationPoint<V>& p, V share, PointTangent<V, MODE>& out)
{
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    out.f_dr[4 * k] += share * (2.0 * in.damping * p.transport_speed * e.mass);
}
}  // namespace tether_monitor::core::kernel
