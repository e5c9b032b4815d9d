#pragma once

#include "hermite_table.h"
#include "nodal_coordinates.h"

#include "tether_monitor/core/element/axial_law.h"

namespace tether_monitor::core::kernel
{
// The residual alone, or with one of the tangents of TangentKind.
enum class EvaluationMode
{
  RESIDUALS,
  SYMMETRIC,
  COMPLETE
};

// Constants of W elements.
template <class V>
struct ElementConstants
{
  V length, inverse_length, mass, diameter;
  AxialCoefficients<V> axial;
  V viscosity, inverse_natural;  // tau EA [N s], 1 / lambda_0
  V half_rho_d, rho_area, drag_normal, drag_tangential, added_mass, added_mass_tangential, compression;
};

template <int W>
TM_INLINE typename Simd<W>::Vector constant(const ElementBlock& in, int first, Constant row)
{
  return load<W>(in.constants + row * BLOCK + first);
}

template <int W>
TM_INLINE ElementConstants<typename Simd<W>::Vector> elementConstants(const ElementBlock& in, int first)
{
  using V = typename Simd<W>::Vector;
  ElementConstants<V> e;
  e.length = constant<W>(in, first, LENGTH);
  e.inverse_length = 1.0 / e.length;
  e.mass = constant<W>(in, first, MASS);
  e.diameter = constant<W>(in, first, DIAMETER);
  e.axial = axialCoefficients(constant<W>(in, first, AXIAL_STIFFNESS), constant<W>(in, first, COMPRESSION_LIMIT),
                              constant<W>(in, first, COMPRESSION_STIFFNESS_RATIO));
  e.viscosity = constant<W>(in, first, AXIAL_VISCOSITY);
  e.inverse_natural = 1.0 / constant<W>(in, first, NATURAL_STRETCH);
  e.half_rho_d = 0.5 * in.around->density * e.diameter;
  e.rho_area = in.around->density * constant<W>(in, first, AREA);
  e.drag_normal = constant<W>(in, first, DRAG_NORMAL);
  e.drag_tangential = constant<W>(in, first, DRAG_TANGENTIAL);
  e.added_mass = constant<W>(in, first, ADDED_MASS);
  e.added_mass_tangential = constant<W>(in, first, ADDED_MASS_TANGENTIAL);
  e.compression = constant<W>(in, first, COMPRESSION);
  return e;
}

// One integration point of W elements: how the tether moves there, and the load per metre that the terms add up.
template <class V>
struct IntegrationPoint
{
  V weight;                // share of the element times its length
  V r[3], t[3];            // place, slope
  V velocity[3], rate[3];  // of the material, and of its slope
  V acceleration[3];
  V transport_speed;  // of the material through the mesh
  V inverse_square;   // 1 / |t|^2
  V f[3];             // force that is needed [N/m]
};

template <class V>
TM_INLINE IntegrationPoint<V> integrationPoint(int g, const ElementConstants<V>& e, const Coords<V>& q,
                                               const Coords<V>& v, const Coords<V>& a)
{
  IntegrationPoint<V> p;
  p.weight = HERMITE.weight[g] * e.length;
  p.transport_speed = V{};
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    p.r[k] = at(HERMITE.N[g], q, k);
    p.t[k] = e.inverse_length * slopeAt(HERMITE.dN[g], q, k);
    p.rate[k] = e.inverse_length * slopeAt(HERMITE.dN[g], v, k);
    p.velocity[k] = at(HERMITE.N[g], v, k);
    p.acceleration[k] = at(HERMITE.N[g], a, k);
    p.f[k] = V{};
  }
  p.inverse_square = 1.0 / lanes::max(dot(p.t, p.t), lanes::broadcast<V>(1e-24));
  return p;
}

// Tangent of the loads at one point: of f with r, of n with r', of f with r', each times the point's weight.
template <class V, EvaluationMode MODE>
struct PointTangent
{
  static constexpr bool COMPLETE = MODE == EvaluationMode::COMPLETE;
  V f_r[6], n_dr[COMPLETE ? 9 : 6], f_dr[COMPLETE ? 9 : 1];
};
}  // namespace tether_monitor::core::kernel
