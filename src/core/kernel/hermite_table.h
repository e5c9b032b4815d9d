#pragma once

#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"
#include "tether_monitor/core/kernel/kernel.h"

namespace tether_monitor::core::kernel
{
// The shape functions N, their first and second derivatives at the points of quadrature.h, for an element of unit
// length: they multiply r_a, l r'_a, r_b, l r'_b. The same numbers for all elements.
struct HermiteTable
{
  double weight[POINTS], axial[POINTS], xi[POINTS], N[POINTS][4], dN[POINTS][4], ddN[POINTS][4], ddN_node[2][4];

  constexpr HermiteTable() : weight(), axial(), xi(), N(), dN(), ddN(), ddN_node()
  {
    for (int g = 0; g < POINTS; ++g)
    {
      weight[g] = QUADRATURE[g].weight;
      axial[g] = QUADRATURE[g].axial;
      xi[g] = QUADRATURE[g].xi;
      const ShapeValues value = shapeFunctions(xi[g], 1.0), slope = shapeSlopes(xi[g], 1.0);
      const ShapeValues curvature = shapeCurvatures(xi[g], 1.0);
      for (int i = 0; i < 4; ++i)
      {
        N[g][i] = value[i];
        dN[g][i] = slope[i];
        ddN[g][i] = curvature[i];
      }
    }
    for (int end = 0; end < 2; ++end)
      for (int i = 0; i < 4; ++i)
        ddN_node[end][i] = shapeCurvatures(end, 1.0)[i];
  }
};
inline constexpr HermiteTable HERMITE;

// Place of entry (r, c) of a symmetric 3 x 3 matrix, and of pair (i, j) of a symmetric 4 x 4 one.
static constexpr int packedIndex3(int r, int c)
{
  return r <= c ? 3 * r - r * (r + 1) / 2 + c : packedIndex3(c, r);
}
static constexpr int packedIndex4(int i, int j)
{
  return i <= j ? 4 * i - i * (i + 1) / 2 + j : packedIndex4(j, i);
}
}  // namespace tether_monitor::core::kernel
