#pragma once

#include "axial_term.h"
#include "bending_term.h"
#include "drag_term.h"
#include "payout_flow_term.h"
#include "scatter.h"

// The equations of an element, (M1)-(M11) and (M24) of doc/model.md, for W elements at once: one term a file.
// Inside, slopes are multiplied by the element's length: then the shape functions are the same numbers for all
// elements.

namespace tether_monitor::core::kernel
{
// d f / d r' at one point: drag, added mass and payout.
template <class V, EvaluationMode MODE>
TM_INLINE void setSlopeTangent(int g, const ElementBlock& in, const ElementConstants<V>& e,
                               const IntegrationPoint<V>& p, const MorisonDrag<V>& water,
                               const MorisonDrag<V>* air, const AddedMassForce<V>& added,
                               PointTangent<V, MODE>& out)
{
  const V share = lanes::broadcast<V>(HERMITE.weight[g]);
#pragma GCC unroll 3
  for (int row = 0; row < 3; ++row)
#pragma GCC unroll 3
    for (int column = 0; column < 3; ++column)
    {
      V x = morisonDragSlopeTangent(water, p.t, p.inverse_square, row, column);
      if (air)
        x += morisonDragSlopeTangent(*air, p.t, p.inverse_square, row, column);
      x += addedMassSlopeTangent(added, p, row, column);
      out.f_dr[3 * row + column] = share * (in.stiffness * x);
    }
  addPayoutFlowTangent(in, e, p, share, out);
}

// All terms at one integration point, added to the residual; the tangent of the point if it is wanted.
template <int W, EvaluationMode MODE, class V>
TM_INLINE void addPoint(int g, const ElementBlock& in, int first, const ElementConstants<V>& e, const Coords<V>& q,
                        const Coords<V>& v, const Coords<V>& a, V (&R)[4][3], PointTangent<V, MODE>& tangent)
{
  IntegrationPoint<V> p = integrationPoint(g, e, q, v, a);
  if (in.has_transport)
    addPayoutFlow<W>(g, in, first, e, q, v, p);
  const AxialForce<V> axial = axialForce<W>(in, first, e, p.t, p.rate);
  const WaterAtPoint<V> water = waterAtPoint<W>(g, in, first, e, p);
  addWeightAndBuoyancy(in, e, water, p);
  const AddedMassForce<V> added = addAddedMass(e, water, p);
  const MorisonDrag<V> drag = addWaterDrag(e, water, p);
  const bool blows = water.emerges && in.around->has_wind;
  MorisonDrag<V> air;
  if (blows)
    air = addWindDrag<W>(in, e, water, p);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    const V load_f = p.weight * p.f[k], load_n = HERMITE.axial[g] * axial.N * p.t[k];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i)
      R[i][k] += HERMITE.N[g][i] * load_f + HERMITE.dN[g][i] * load_n;
  }
  if constexpr (MODE != EvaluationMode::RESIDUALS)
  {
    setFlowTangent(in, drag, added, p, tangent);
    addBuoyancyTangent(in, water, p, tangent);
    if (blows)
      addWindTangent(in, air, p, tangent);
    axialTangent<MODE == EvaluationMode::COMPLETE>(axial, e, p.t, p.rate, HERMITE.axial[g] * e.inverse_length, in,
                                                   tangent.n_dr);
    if constexpr (MODE == EvaluationMode::COMPLETE)
      setSlopeTangent(g, in, e, p, drag, blows ? &air : nullptr, added, tangent);
  }
}

template <int W, EvaluationMode MODE>
TM_INLINE void elementKernel(const ElementBlock& in, int first, int count)
{
  using V = typename Simd<W>::Vector;
  const ElementConstants<V> e = elementConstants<W>(in, first);
  const bool may_overrun = in.count - first > W || in.nodes_after > 0;
  const Coords<V> q = coordsAt<W>(in.q + 6 * first, count, may_overrun, e.length);
  const Coords<V> v = coordsAt<W>(in.v + 6 * first, count, may_overrun, e.length);
  const Coords<V> a = coordsAt<W>(in.a + 6 * first, count, may_overrun, e.length);
  const V inertia = e.mass * e.length;
  const V bending =
      constant<W>(in, first, BENDING_STIFFNESS) * e.inverse_length * e.inverse_length * e.inverse_length;

  V R[4][3];
  setInertia(inertia, a, R);
  addBending(bending, q, R);
  PointTangent<V, MODE> tangent[POINTS];
#pragma GCC unroll 3
  for (int g = 0; g < POINTS; ++g)
    addPoint<W>(g, in, first, e, q, v, a, R, tangent[g]);
  V node_dr[2][9];
#pragma GCC unroll 2
  for (int end = 0; end < 2; ++end)
    addAxialAtNode<W, MODE>(end, in, first, e, q, v, R, node_dr[end]);

  const NodeForces<V> force = nodeForces(R, e.length);
  if constexpr (MODE == EvaluationMode::RESIDUALS)
  {
    scatterElements<W>(force, in, first, count);
  }
  else
  {
    scatterNodes<W>(force, in, first, count);
    ElementTangent<V, MODE> sum;
    sumTangent(in, inertia, bending, e.length, tangent, node_dr, sum);
    scatterTangent<W>(sum, in, first, count);
  }
}

template <int W, EvaluationMode MODE>
void elementsKernel(const ElementBlock& in)
{
  for (int first = 0; first < in.count; first += W)
    elementKernel<W, MODE>(in, first, in.count - first < W ? in.count - first : W);
}
}  // namespace tether_monitor::core::kernel
