#include "tether_monitor/core/element/element_matrices.h"

namespace tether_monitor::core
{
namespace
{
// From slopes times the length to slopes: rows and columns 1 and 3 get a factor L.
ShapeMatrix scaled(const double (&unit)[4][4], double factor, double L)
{
  ShapeMatrix m;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      m(i, j) = factor * (i % 2 == 1 ? L : 1.0) * (j % 2 == 1 ? L : 1.0) * unit[i][j];
  return m;
}
}  // namespace

ShapeMatrix massMatrix(double L)
{
  return scaled(UNIT_MASS, L / UNIT_MASS_DIVISOR, L);
}

ShapeMatrix bendingMatrix(double L)
{
  return scaled(UNIT_BENDING, 1.0 / (L * L * L), L);
}

}  // namespace tether_monitor::core
