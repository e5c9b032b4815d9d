#pragma once

#include "tether_monitor/core/element/quadrature.h"
#include "tether_monitor/core/kernel/kernel.h"

namespace tether_monitor::core::kernel
{
// Hermite functions N, their slopes dN and curvatures ddN at the points of quadrature.h, for r_a, l r'_a, r_b, l
// r'_b.
struct HermiteTable
{
  double weight[POINTS], axial[POINTS], xi[POINTS], N[POINTS][4], dN[POINTS][4], ddN[POINTS][4], ddN_node[2][4];

  constexpr HermiteTable()
    : weight(), axial(), xi(), N(), dN(), ddN(), ddN_node{{-6.0, -4.0, 6.0, -2.0}, {6.0, 2.0, -6.0, 4.0}}
  {
    for (int g = 0; g < POINTS; ++g)
    {
      const double x = QUADRATURE[g].xi;
      weight[g] = QUADRATURE[g].weight;
      axial[g] = QUADRATURE[g].axial;
      xi[g] = x;
      N[g][0] = 1.0 - 3.0 * x * x + 2.0 * x * x * x;
      N[g][1] = x - 2.0 * x * x + x * x * x;
      N[g][2] = 3.0 * x * x - 2.0 * x * x * x;
      N[g][3] = x * x * x - x * x;
      dN[g][0] = 6.0 * (x * x - x);
      dN[g][1] = 1.0 - 4.0 * x + 3.0 * x * x;
      dN[g][2] = 6.0 * (x - x * x);
      dN[g][3] = 3.0 * x * x - 2.0 * x;
      ddN[g][0] = 12.0 * x - 6.0;
      ddN[g][1] = 6.0 * x - 4.0;
      ddN[g][2] = 6.0 - 12.0 * x;
      ddN[g][3] = 6.0 * x - 2.0;
    }
  }
};
inline constexpr HermiteTable HERMITE;

// Consistent mass over m l, and bending over EI / l^3.
inline constexpr double MASS_SHARE[4][4] = {{156.0 / 420.0, 22.0 / 420.0, 54.0 / 420.0, -13.0 / 420.0},
                                            {22.0 / 420.0, 4.0 / 420.0, 13.0 / 420.0, -3.0 / 420.0},
                                            {54.0 / 420.0, 13.0 / 420.0, 156.0 / 420.0, -22.0 / 420.0},
                                            {-13.0 / 420.0, -3.0 / 420.0, -22.0 / 420.0, 4.0 / 420.0}};
inline constexpr double BENDING_SHARE[4][4] = {
    {12.0, 6.0, -12.0, 6.0}, {6.0, 4.0, -6.0, 2.0}, {-12.0, -6.0, 12.0, -6.0}, {6.0, 2.0, -6.0, 4.0}};

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
