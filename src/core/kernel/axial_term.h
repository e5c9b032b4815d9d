#pragma once

#include "integration_point.h"

namespace tether_monitor::core::kernel
{
// Axial force (M3), (M5) at one place: n = N t.
template <class V>
struct AxialForce
{
  V N;        // over the stretched slope
  V modulus;  // dN / d eps of the law alone
};

// (M32)
template <int W, class V>
TM_INLINE void addStiffening(const ElementBlock& in, int first, V eps, AxialForce<V>& out)
{
#pragma GCC unroll 1
  for (int k = 0; k < AxialStiffening::MOST; ++k)
  {
    const double* strain = in.constants + (STIFFENING_STRAIN + k) * BLOCK + first;
    const V change = load<W>(strain + AxialStiffening::MOST * BLOCK);
    const V beyond = eps - load<W>(strain);
    out.N += change * lanes::max(beyond, V{});
    out.modulus += beyond > 0.0 ? change : V{};
  }
}

template <int W, class V>
TM_INLINE AxialForce<V> axialForce(const ElementBlock& in, int first, const ElementConstants<V>& e, const V* t,
                                   const V* rate)
{
  const V square = e.inverse_natural * e.inverse_natural;
  const V eps = 0.5 * (square * dot(t, t) - 1.0);
  const AxialResponse<V> response = axialResponse(e.axial, eps);
  AxialForce<V> out{response.force, response.modulus};
  if (in.has_stiffening)
    addStiffening<W>(in, first, eps, out);
  if (in.has_damping)
    out.N += e.viscosity * (square * dot(t, rate));
  out.N *= e.inverse_natural;
  return out;
}

// dn/dr' times `share`, weighted: symmetric (6 entries), or complete (9) with what the rate adds.
template <bool COMPLETE, class V>
TM_INLINE void axialTangent(const AxialForce<V>& axial, const ElementConstants<V>& e, const V* t, const V* rate,
                            V share, const ElementBlock& in, V* out)
{
  const V cube = share * e.inverse_natural * (e.inverse_natural * e.inverse_natural);
  const V along_t = cube * (in.stiffness * axial.modulus + in.damping * e.viscosity);
  const V along_rate = cube * in.stiffness * e.viscosity;
  const V even = share * in.stiffness * axial.N;
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

// The little axial energy at the nodes, (M4), and its tangent.
template <int W, EvaluationMode MODE, class V>
TM_INLINE void addAxialAtNode(int end, const ElementBlock& in, int first, const ElementConstants<V>& e,
                              const Coords<V>& q, const Coords<V>& v, V (&R)[4][3], V* tangent)
{
  V t[3], rate[3];
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    t[k] = e.inverse_length * q.x[2 * end + 1][k];
    rate[k] = e.inverse_length * v.x[2 * end + 1][k];
    if (in.has_transport)
      rate[k] += constant<W>(in, first, end == 0 ? TRANSPORT_SPEED_A : TRANSPORT_SPEED_B) * e.inverse_length *
                 e.inverse_length * slopeAt(HERMITE.ddN_node[end], q, k);
  }
  const AxialForce<V> axial = axialForce<W>(in, first, e, t, rate);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
    R[2 * end + 1][k] += AXIAL_AT_NODES * axial.N * t[k];
  if constexpr (MODE != EvaluationMode::RESIDUALS)
    axialTangent<MODE == EvaluationMode::COMPLETE>(axial, e, t, rate, AXIAL_AT_NODES * e.inverse_length, in,
                                                   tangent);
}
}  // namespace tether_monitor::core::kernel
