#include "tether_monitor/core/bending_response.h"

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
