#pragma once

#include "tether_monitor/core/types.h"

namespace tether_monitor::core
{
/// Drag per unstretched metre on the water, that is minus the drag on the tether, and its derivatives.
struct DragLaw
{
  Vector3 force;       ///< [N/m], along the velocity relative to the water.
  Matrix3 d_velocity;  ///< d force / d u [N s/m^2]; symmetric, positive semidefinite.
  Matrix3 d_slope;     ///< d force / d r' [N/m]; not symmetric: the load follows the direction.
};

/**
 * Normal and tangential drag of a slender body, with derivatives.
 *
 * Model: f = 1/2 rho d (Cn |un| un + Ct |ut| ut), un and ut the parts of u normal and tangential to r', (M9) of
 * doc/model.md; Morison et al. (1950), independence principle. Both coefficients refer to diameter * length.
 *
 * @param normal      1/2 rho d Cn [kg/m^2], >= 0.
 * @param tangential  1/2 rho d Ct [kg/m^2], >= 0.
 * @param u           velocity of the tether relative to the water [m/s].
 * @param slope       r' [-]; only its direction counts. A zero vector has no direction: all drag is then normal.
 */
DragLaw morisonDrag(double normal, double tangential, const Vector3& u, const Vector3& slope);

/// The force of morisonDrag() alone.
Vector3 morisonDragForce(double normal, double tangential, const Vector3& u, const Vector3& slope);

}  // namespace tether_monitor::core
