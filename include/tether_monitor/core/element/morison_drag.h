#pragma once

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/**
 * Drag per unstretched metre of a slender body on the water, that is minus the drag on the body [N/m]; what steps
 * a tether has the same law in its kernels (kernel/laws.h), with derivatives.
 *
 * Model: f = 1/2 rho d (Cn |un| un + Ct |ut| ut), un and ut the parts of u normal and tangential to r', (M9) of
 * doc/model.md; Morison et al. (1950), independence principle. Both coefficients refer to diameter * length.
 *
 * @param normal      1/2 rho d Cn [kg/m^2], >= 0.
 * @param tangential  1/2 rho d Ct [kg/m^2], >= 0.
 * @param u           velocity of the tether relative to the water [m/s].
 * @param slope       r' [-]; only its direction counts. A zero vector has no direction: all drag is then normal.
 */
Vector3 morisonDragForce(double normal, double tangential, const Vector3& u, const Vector3& slope);

}  // namespace tether_monitor::core
