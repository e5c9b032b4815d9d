#pragma once

#include "tether_monitor/core/base/tangent_weights.h"
#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/cable/friction_state.h"

namespace tether_monitor::core
{
/// Damping over stiffness of an obstacle [s].
constexpr double OBSTACLE_DAMPING = 1.0e-3;

/// One surface under one point of a tether: what it is made of, per metre of tether, and how the point moves
/// against it.
struct ContactPoint
{
  double stiffness = 0.0;    ///< k d [N/m^2]
  double damping = 0.0;      ///< c d [N s/m^2]
  double friction = 0.0;     ///< Coulomb's mu [-]
  double penetration = 0.0;  ///< [m], > 0 in contact.
  Vector3 normal = Vector3::UnitZ();
  Matrix3 curvature = Matrix3::Zero();  ///< d normal / d point [1/m].
  Vector3 velocity = Vector3::Zero();   ///< of the point against the surface [m/s].
  Vector3 stretch = Vector3::Zero();    ///< of the friction spring before it slips [m].
  FrictionMode friction_mode = FrictionMode::COULOMB;
};

/// Force of a surface on a tether, per metre.
struct ContactResponse
{
  Vector3 force = Vector3::Zero();      ///< [N/m]
  Vector3 stretch = Vector3::Zero();    ///< of the friction spring [m].
  Matrix3 stiffness = Matrix3::Zero();  ///< weighted -d force / d point, see TangentWeights.
  double normal_force = 0.0;            ///< [N/m], >= 0; 0: no contact.
  double energy = 0.0;                  ///< in both springs [J/m].
};

/**
 * The law of contact: a normal spring that begins softly and a damper, never in tension, (M22); a friction spring
 * that slips at mu N, (M23).
 *
 * @param diameter  of the tether [m].
 */
ContactResponse contactForce(const ContactPoint& on, double diameter, const TangentWeights& weights);

}  // namespace tether_monitor::core
