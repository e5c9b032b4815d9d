#pragma once

#include "tether_monitor/core/element/axial_law.h"
#include "tether_monitor/core/element/slope_transition.h"

namespace tether_monitor::core
{
/**
 * Motion of the tether through the mesh while it is paid out, (M24) of doc/model.md: the mesh is arbitrary
 * Lagrangian-Eulerian there.
 *
 * An element between the vessel end and the first fixed point of the tether grows with the deployed length, and
 * the tether slides through it with speed c towards larger s.
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
};

/// Constants of one element, ready for the stepping path (no checks there: CableModel checks at set-up).
struct ElementParameters
{
  double length = 0.0;                 ///< L [m], unstretched, > 0.
  double diameter = 0.0;               ///< d [m].
  double contact_diameter = 0.0;       ///< dc [m], of what touches floor and obstacles.
  double mass = 0.0;                   ///< m [kg/m], dry.
  double area = 0.0;                   ///< displaced cross-section [m^2].
  double drag_normal = 0.0;            ///< Cn [-].
  double drag_tangential = 0.0;        ///< Ct [-].
  double added_mass = 0.0;             ///< Can [-].
  double added_mass_tangential = 0.0;  ///< Cat [-].
  AxialParameters axial;
  double bending_stiffness = 0.0;  ///< EI with its regularisation [N m^2].
  double compression = 0.0;        ///< relative change of diameter per metre of depth [1/m], >= 0.
  double natural_stretch = 1.0;    ///< lambda_0 = 1 + permanent elongation [-].
  AxialTransport transport;
  SlopeTransition at_a, at_b;  ///< where a neighbour is softer.
  bool parted = false;         ///< nothing is there any more but the distance of two broken ends.

  /// True if a slope of its own is not that of the node.
  bool isJoined() const { return at_a.active || at_b.active; }
};

}  // namespace tether_monitor::core
