#pragma once

#include "tether_monitor/core/bending_response.h"

namespace tether_monitor::core
{
/**
 * Integral of S_i S_j over an element: the consistent mass matrix is m times this matrix.
 *
 * Model: (M7) of doc/model.md; Blintsov & Trunin (2020), eqs 9 and 14. Exact (degree 6 integrated analytically).
 *
 * @param L  unstretched length of the element [m], > 0.
 */
ShapeMatrix massMatrix(double L);

}  // namespace tether_monitor::core
