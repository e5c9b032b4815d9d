#pragma once

#include "tether_monitor/core/base/tangent_weights.h"
#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/element/element_parameters.h"
#include "tether_monitor/core/environment/environment_model.h"

namespace tether_monitor::core
{
/// Coordinates of an element with their first and second time derivatives.
struct ElementMotion
{
  ElementCoords q;
  ElementCoords v;
  ElementCoords a;
  double time = 0.0;  ///< [s], for the waves.
};

/**
 * Residual of the equations of motion of one element: the forces that its nodes must receive from outside.
 *
 * Model: R = M a + Q_axial + Q_bending + Q_drag + Q_weight, (M11) of doc/model.md; axial (M2)-(M5), bending (M6),
 * inertia (M7) and (M10), weight and buoyancy (M8), drag (M9). Loads and the axial term use QUADRATURE.
 * The arithmetic is that of the kernels (kernel.h); a whole tether goes through ElementAssembler instead, one
 * element through here: for set-up and tests, for it allocates.
 *
 * @param p            constants of the element.
 * @param motion       coordinates and rates; finite.
 * @param residual     out: 3-vectors conjugate to r_a, r'_a, r_b, r'_b [N, N m, N, N m].
 */
void elementResidual(const ElementParameters& p, const EnvironmentModel& environment, const ElementMotion& motion,
                     ElementCoords& residual);

/// As above, with the iteration matrix.
/// @param weights  see TangentWeights.
/// @param tangent  out: derivative of the residual, weighted.
void elementResidual(const ElementParameters& p, const EnvironmentModel& environment, const ElementMotion& motion,
                     const TangentWeights& weights, ElementCoords& residual, ElementMatrix& tangent);

/// Energies of one element [J].
struct ElementEnergy
{
  double axial;    ///< integral of the strain energy (M4).
  double bending;  ///< (M6).
  double kinetic;  ///< of the dry mass, (M7).
  double weight;   ///< m g z of the dry weight; zero at z = 0.

  double total() const { return axial + bending + kinetic + weight; }
};

/// Energies of an element with gravity g [m/s^2]; buoyancy and added mass are not counted.
ElementEnergy elementEnergy(const ElementParameters& p, double gravity, const ElementCoords& q,
                            const ElementCoords& v);

}  // namespace tether_monitor::core
