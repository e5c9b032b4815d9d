#pragma once

#include "hermite_table.h"
#include "simd.h"

// The laws of one integration point, for W elements at once.

namespace tether_monitor::core::kernel
{
template <class V>
TM_INLINE V dot(const V* a, const V* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Drag (M9): force, and weighted derivatives as  alpha I + beta t t' + gamma un un'  with respect to velocity.
template <class V>
struct Drag
{
  V force[3], across[3];
  V along, alpha, beta, gamma;  // along: t . u
  V normal_speed, tangent_speed;
};

template <int W, class V>
TM_INLINE Drag<V> drag(V normal, V tangential, const V* u, const V* t, V inverse_square)
{
  Drag<V> d;
  d.along = dot(t, u);
  const V share = d.along * inverse_square;
  for (int k = 0; k < 3; ++k)
    d.across[k] = u[k] - share * t[k];
  const V square = dot(d.across, d.across);
  d.normal_speed = normal * sqrt<W>(square);
  d.tangent_speed = tangential * abs(d.along) * sqrt<W>(inverse_square);
  for (int k = 0; k < 3; ++k)
    d.force[k] = d.normal_speed * d.across[k] + d.tangent_speed * share * t[k];
  d.alpha = d.normal_speed;
  d.beta = inverse_square * (2.0 * d.tangent_speed - d.normal_speed);
  d.gamma = d.normal_speed / max(square, broadcast<W>(1e-24));
  return d;
}

// d force / d slope of the same, (row, column).
template <class V>
TM_INLINE V turning(const Drag<V>& d, const V* t, V inverse_square, int row, int column)
{
  const V unit = row == column ? V{} + 1.0 : V{};
  const V plane = unit - inverse_square * t[row] * t[column];
  return inverse_square * (d.tangent_speed * (2.0 * t[row] * d.across[column] + d.along * plane) -
                           (d.normal_speed * t[row] * d.across[column] +
                            d.along * (d.normal_speed * plane + d.gamma * d.across[row] * d.across[column])));
}

// Axial law (M3), (M5) at one place: n = N t, and what its derivative is made of.
template <class V>
struct Axial
{
  V N;         // force over the stretched slope
  V modulus;   // dN/d(eps) of the law alone
  V natural2;  // 1 / lambda_0^2
  V natural;   // 1 / lambda_0
};

template <class V>
struct AxialConstants
{
  V stiff_part, soft_part, push_rate, viscosity, natural;
};

template <int W, class V>
TM_INLINE Axial<V> axial(const AxialConstants<V>& p, const V* t, const V* rate, bool has_damping)
{
  Axial<V> out;
  out.natural = p.natural;
  out.natural2 = p.natural * p.natural;
  const V strain = 0.5 * (out.natural2 * dot(t, t) - 1.0);
  const V push = max(-strain * p.push_rate, V{});
  V give = broadcast<W>(1.0);
  if (any<W>(push > 0.0))
    give = 1.0 / (1.0 + push);
  out.N = p.stiff_part * strain + p.soft_part * strain * give;
  if (has_damping)
    out.N += p.viscosity * (out.natural2 * dot(t, rate));
  out.N *= p.natural;
  out.modulus = p.stiff_part + p.soft_part * give * give;
  return out;
}

// dn/dr' times `share`, weighted: symmetric (6 entries), or complete (9) with what the rate adds.
template <bool COMPLETE, class V>
TM_INLINE void axialTangent(const Axial<V>& a, const AxialConstants<V>& p, const V* t, const V* rate, V share,
                            double damping, double stiffness, V* out)
{
  const V cube = share * a.natural * a.natural2;
  const V along_t = cube * (stiffness * a.modulus + damping * p.viscosity);
  const V along_rate = cube * stiffness * p.viscosity;
  const V even = share * stiffness * a.N;
#pragma GCC unroll 3
  for (int row = 0; row < 3; ++row)
#pragma GCC unroll 3
    for (int column = COMPLETE ? 0 : row; column < 3; ++column)
    {
      V x = along_t * t[row] * t[column];
      if (COMPLETE)
        x += along_rate * t[row] * rate[column];
      if (row == column)
        x += even;
      out[COMPLETE ? 3 * row + column : packedIndex3(row, column)] = x;
    }
}
}  // namespace tether_monitor::core::kernel
