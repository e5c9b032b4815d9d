#pragma once

#include "inertia_term.h"

namespace tether_monitor::core::kernel
{
// What the nodes a and b of W elements receive; slopes get their length back.
template <class V>
struct NodeForces
{
  V a[6], b[6];
};

template <class V>
TM_INLINE NodeForces<V> nodeForces(const V (&R)[4][3], V length)
{
  NodeForces<V> out;
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    out.a[k] = R[0][k];
    out.a[3 + k] = length * R[1][k];
    out.b[k] = R[2][k];
    out.b[3 + k] = length * R[3][k];
  }
  return out;
}

// Each element's residual for itself.
template <int W, class V>
TM_INLINE void scatterElements(const NodeForces<V>& force, const ElementBlock& in, int first, int count)
{
  double rows_a[W][8], rows_b[W][8];
  scatter<W>(force.a, rows_a[0], 8, W);
  scatter<W>(force.b, rows_b[0], 8, W);
  for (int e = 0; e < count; ++e)
    for (int k = 0; k < 6; ++k)
    {
      in.element_residual[12 * (first + e) + k] = rows_a[e][k];
      in.element_residual[12 * (first + e) + 6 + k] = rows_b[e][k];
    }
}

// Residuals summed at the nodes.
template <int W, class V>
TM_INLINE void scatterNodes(const NodeForces<V>& force, const ElementBlock& in, int first, int count)
{
  double rows[W][8];
  V sum[6];
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k)
    sum[k] = force.a[k] + shiftIn<W>(force.b[k]);
  scatter<W>(sum, rows[0], 8, W);
  double* node = in.residual + 6 * first;
  for (int k = 0; k < 6; ++k)
    node[k] += rows[0][k];
  for (int e = 1; e < count; ++e)
    for (int k = 0; k < 6; ++k)
      node[6 * e + k] = rows[e][k];
  for (int k = 0; k < 6; ++k)
    node[6 * count + k] = force.b[k][count - 1];
}

// The 12 x 12 tangents of W elements in 3 x 3 blocks of the four vectors of an element: all, or the upper half.
template <class V, EvaluationMode MODE>
struct ElementTangent
{
  static constexpr bool COMPLETE = MODE == EvaluationMode::COMPLETE;
  V K[COMPLETE ? 16 : 10][COMPLETE ? 9 : 6];

  TM_INLINE V entry(int i, int row, int j, int column) const
  {
    if constexpr (COMPLETE)
      return K[4 * i + j][3 * row + column];
    else
      return K[packedIndex4(i, j)][packedIndex3(row, column)];
  }
  TM_INLINE void column(int node_row, int node_column, int column, V* x) const
  {
#pragma GCC unroll 6
    for (int row = 0; row < 6; ++row)
      x[row] = entry(2 * node_row + row / 3, row % 3, 2 * node_column + column / 3, column % 3);
  }
};

// Sums over the points; the linear terms join on the diagonals. Slopes get their length back.
template <EvaluationMode MODE, class V>
TM_INLINE void sumTangent(const ElementBlock& in, V inertia, V bending, V length,
                          const PointTangent<V, MODE> (&point)[POINTS], const V (&node_dr)[2][9],
                          ElementTangent<V, MODE>& out)
{
  constexpr bool COMPLETE = MODE == EvaluationMode::COMPLETE;
  const V scale[4] = {lanes::broadcast<V>(1.0), length, lanes::broadcast<V>(1.0), length};
#pragma GCC unroll 4
  for (int i = 0; i < 4; ++i)
#pragma GCC unroll 4
    for (int j = COMPLETE ? 0 : i; j < 4; ++j)
    {
      const V linear = in.mass * inertiaEntry(inertia, i, j) + in.stiffness * bending * UNIT_BENDING[i][j];
      const V both = scale[i] * scale[j];
      V* const k = out.K[COMPLETE ? 4 * i + j : packedIndex4(i, j)];
#pragma GCC unroll 3
      for (int row = 0; row < 3; ++row)
#pragma GCC unroll 3
        for (int column = COMPLETE ? 0 : row; column < 3; ++column)
        {
          V x = row == column ? linear : V{};
          const int place = COMPLETE ? 3 * row + column : packedIndex3(row, column);
#pragma GCC unroll 3
          for (int g = 0; g < POINTS; ++g)
          {
            x += (HERMITE.N[g][i] * HERMITE.N[g][j]) * point[g].f_r[packedIndex3(row, column)];
            x += (HERMITE.dN[g][i] * HERMITE.dN[g][j]) * point[g].n_dr[place];
            if constexpr (COMPLETE)
              x += (HERMITE.N[g][i] * HERMITE.dN[g][j]) * point[g].f_dr[place];
          }
          if (i == j && i % 2 == 1)
            x += node_dr[i / 2][place];
          k[place] = i % 2 + j % 2 == 0 ? x : both * x;
        }
    }
}

// Into the block-tridiagonal matrix.
template <int W, class V, EvaluationMode MODE>
TM_INLINE void scatterTangent(const ElementTangent<V, MODE>& tangent, const ElementBlock& in, int first, int count)
{
#pragma GCC unroll 6
  for (int column = 0; column < 6; ++column)
  {
    const int offset = MATRIX * first + column * COLUMN;
    V x[6], y[6];
    tangent.column(0, 1, column, x);
    scatter<W>(x, in.upper + offset, MATRIX, count);
    tangent.column(1, 0, column, x);
    scatter<W>(x, in.lower + offset, MATRIX, count);
    tangent.column(0, 0, column, x);
    tangent.column(1, 1, column, y);
    double* after = in.diagonal + offset + MATRIX * count;
#pragma GCC unroll 6
    for (int row = 0; row < 6; ++row)
    {
      x[row] += shiftIn<W>(y[row]);
      after[row] = y[row][count - 1];
    }
    after[6] = after[7] = 0.0;
    scatter<W>(x, in.diagonal + offset, MATRIX, count, true);
  }
}
}  // namespace tether_monitor::core::kernel
