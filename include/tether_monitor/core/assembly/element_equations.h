#pragma once

#include "tether_monitor/core/element/axial_law.h"
#include "tether_monitor/core/element/element_matrices.h"
#include "tether_monitor/core/environment/environment_model.h"

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/**
 * Motion of the tether through the mesh while it is paid out, (M24) of doc/model.md.
 *
 * An element between the vessel end and the first fixed point of the tether grows with the deployed length, and
 * the tether runs through it with speed c towards larger s.
 */
struct AxialTransport
{
  bool active = false;
  double growth = 0.0;        ///< l'/l [1/s], l' the rate of the element's length.
  double acceleration = 0.0;  ///< l''/l [1/s^2].
  double speed_a = 0.0;       ///< c at node a [m/s].
  double speed_b = 0.0;       ///< c at node b [m/s].
  double rate_a = 0.0;        ///< dc/dt at node a [m/s^2].
  double rate_b = 0.0;        ///< dc/dt at node b [m/s^2].

  double at(double xi) const { return speed_a + xi * (speed_b - speed_a); }
  double rateAt(double xi) const { return rate_a + xi * (rate_b - rate_a); }
};

/// Constants of one element, ready for the stepping path (no checks there: CableModel checks at set-up).
struct ElementParameters
{
  double length = 0.0;           ///< L [m], unstretched, > 0.
  double diameter = 0.0;         ///< d [m].
  double mass = 0.0;             ///< m [kg/m], dry.
  double area = 0.0;             ///< displaced cross-section [m^2].
  double drag_normal = 0.0;      ///< Cn [-].
  double drag_tangential = 0.0;  ///< Ct [-].
  double added_mass = 0.0;       ///< Can [-].
  AxialParameters axial;
  double bending_stiffness = 0.0;  ///< EI with its regularisation [N m^2].
  double compression = 0.0;        ///< relative change of diameter per metre of depth [1/m], >= 0.
  double natural_stretch = 1.0;    ///< lambda_0 = 1 + permanent elongation [-].
  AxialTransport flow;
};

/// Coordinates of an element with their first and second time derivatives.
struct ElementMotion
{
  ElementCoords q;
  ElementCoords v;
  ElementCoords a;
  double time = 0.0;  ///< [s], for the waves.
};

/// Weights of mass, damping and stiffness in the iteration matrix: J = mass dR/da + damping dR/dv + stiffness
/// dR/dq.
struct TangentWeights
{
  double mass = 1.0;
  double damping = 0.0;
  double stiffness = 0.0;
};

/**
 * Residual of the equations of motion of one element: the forces that its nodes must receive from outside.
 *
 * Model: R = M a + Q_axial + Q_bending + Q_drag + Q_weight, (M11) of doc/model.md; axial (M2)-(M5), bending (M6),
 * inertia (M7) and (M10), weight and buoyancy (M8), drag (M9). Loads and the axial term use QUADRATURE.
 * The arithmetic is that of the kernels (kernel.h); a whole tether goes through ElementAssembler instead, one
 * element through here: for set-up and tests, for it allocates.
 *
 * @param p         constants of the element.
 * @param sea       the environment.
 * @param motion    coordinates and rates; finite.
 * @param residual  out: 3-vectors conjugate to r_a, r'_a, r_b, r'_b [N, N m, N, N m].
 */
void elementResidual(const ElementParameters& p, const EnvironmentModel& sea, const ElementMotion& motion,
                     ElementCoords& residual);

/// As above, with the iteration matrix.
/// @param weights  see TangentWeights.
/// @param tangent  out: derivative of the residual, weighted.
void elementResidual(const ElementParameters& p, const EnvironmentModel& sea, const ElementMotion& motion,
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
