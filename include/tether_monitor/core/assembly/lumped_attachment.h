#pragma once

#include "tether_monitor/core/assembly/element_equations.h"

namespace tether_monitor::core
{
/// An attachment at a node, ready for the stepping path.
struct LumpedAttachment
{
  int node = 0;
  double mass = 0.0;       ///< [kg]
  double volume = 0.0;     ///< [m^3]
  double drag_area = 0.0;  ///< [m^2]
};

/**
 * Force that an attachment needs from outside, to be added to the residual of its node, and its iteration matrix.
 *
 * Model: m a + (m - rho V phi) g up + 1/2 rho CdA phi |u| u - rho V phi a_water, (M20) of doc/model.md.
 *
 * @param r, v, a  position, velocity and acceleration of the node.
 * @param tangent  out unless null: weighted derivative, see TangentWeights.
 */
Vector3 lumpedAttachmentResidual(const LumpedAttachment& load, const EnvironmentModel& sea, double time,
                                 const Vector3& r, const Vector3& v, const Vector3& a,
                                 const TangentWeights& weights, Matrix3* tangent);

}  // namespace tether_monitor::core
