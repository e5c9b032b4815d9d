#pragma once

#include "tether_monitor/core/kernel/kernel.h"
#include "tether_monitor/core/quadrature.h"

namespace tether_monitor::core::kernel
{
// Hermite functions H, their slopes G and curvatures C at the points of quadrature.h, for r_a, l r'_a, r_b, l
// r'_b.
struct Shape
{
  double weight[POINTS], axial[POINTS], xi[POINTS], H[POINTS][4], G[POINTS][4], C[POINTS][4], C_node[2][4];

  constexpr Shape()
    : weight(), axial(), xi(), H(), G(), C(), C_node{{-6.0, -4.0, 6.0, -2.0}, {6.0, 2.0, -6.0, 4.0}}
  {
    for (int g = 0; g < POINTS; ++g)
    {
      const double x = GAUSS_POINTS[g].xi;
      weight[g] = GAUSS_POINTS[g].weight;
      axial[g] = GAUSS_POINTS[g].axial;
      xi[g] = x;
      H[g][0] = 1.0 - 3.0 * x * x + 2.0 * x * x * x;
      H[g][1] = x - 2.0 * x * x + x * x * x;
      H[g][2] = 3.0 * x * x - 2.0 * x * x * x;
      H[g][3] = x * x * x - x * x;
      G[g][0] = 6.0 * (x * x - x);
      G[g][1] = 1.0 - 4.0 * x + 3.0 * x * x;
      G[g][2] = 6.0 * (x - x * x);
      G[g][3] = 3.0 * x * x - 2.0 * x;
      C[g][0] = 12.0 * x - 6.0;
      C[g][1] = 6.0 * x - 4.0;
      C[g][2] = 6.0 - 12.0 * x;
      C[g][3] = 6.0 * x - 2.0;
    }
  }
};
inline constexpr Shape SHAPE;

// Consistent mass over m l, and bending over EI / l^3.
inline constexpr double MASS_SHARE[4][4] = {{156.0 / 420.0, 22.0 / 420.0, 54.0 / 420.0, -13.0 / 420.0},
                                            {22.0 / 420.0, 4.0 / 420.0, 13.0 / 420.0, -3.0 / 420.0},
                                            {54.0 / 420.0, 13.0 / 420.0, 156.0 / 420.0, -22.0 / 420.0},
                                            {-13.0 / 420.0, -3.0 / 420.0, -22.0 / 420.0, 4.0 / 420.0}};
inline constexpr double BENDING_SHARE[4][4] = {
    {12.0, 6.0, -12.0, 6.0}, {6.0, 4.0, -6.0, 2.0}, {-12.0, -6.0, 12.0, -6.0}, {6.0, 2.0, -6.0, 4.0}};

// Place of entry (r, c) of a symmetric 3 x 3 matrix, and of pair (i, j) of a symmetric 4 x 4 one.
static constexpr int entryOf(int r, int c)
{
  return r <= c ? 3 * r - r * (r + 1) / 2 + c : entryOf(c, r);
}
static constexpr int pairOf(int i, int j)
{
  return i <= j ? 4 * i - i * (i + 1) / 2 + j : pairOf(j, i);
}
}  // namespace tether_monitor::core::kernel
