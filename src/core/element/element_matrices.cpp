#include "tether_monitor/core/element/element_matrices.h"

namespace tether_monitor::core
{
ShapeMatrix bendingMatrix(double L)
{
  ShapeMatrix m;
  m << 12.0, 6.0 * L, -12.0, 6.0 * L,               //
      6.0 * L, 4.0 * L * L, -6.0 * L, 2.0 * L * L,  //
      -12.0, -6.0 * L, 12.0, -6.0 * L,              //
      6.0 * L, 2.0 * L * L, -6.0 * L, 4.0 * L * L;
  return m / (L * L * L);
}

}  // namespace tether_monitor::core
#include "tether_monitor/core/element/element_matrices.h"

namespace tether_monitor::core
{
ShapeMatrix massMatrix(double L)
{
  ShapeMatrix m;
  m << 156.0, 22.0 * L, 54.0, -13.0 * L,              //
      22.0 * L, 4.0 * L * L, 13.0 * L, -3.0 * L * L,  //
      54.0, 13.0 * L, 156.0, -22.0 * L,               //
      -13.0 * L, -3.0 * L * L, -22.0 * L, 4.0 * L * L;
  return m * (L / 420.0);
}

}  // namespace tether_monitor::core
