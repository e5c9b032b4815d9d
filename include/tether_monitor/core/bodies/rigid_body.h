#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// A box-shaped hull that pierces the surface; its buoyancy follows the waves. Axes of the body.
struct Hull
{
  Vector3 size = Vector3::Zero();  ///< length, beam, height [m], each > 0.
  Vector3 keel = Vector3::Zero();  ///< centre of the bottom, from the centre of mass [m].
};

/// Constants of a simulated rigid body at a tether end. Vectors are along its axes (x forward, y left, z up).
struct RigidBody
{
  double mass = 0.0;                        ///< [kg], > 0.
  double volume = 0.0;                      ///< displaced [m^3], >= 0; not used with a hull.
  Vector3 inertia = Vector3::Zero();        ///< [kg m^2] about the centre of mass, each > 0.
  Vector3 drag_area = Vector3::Zero();      ///< CdA [m^2], each >= 0: F_i = -1/2 rho CdA_i |v| v_i, v relative to
                                            ///< the water.
  Vector3 added_mass = Vector3::Zero();     ///< [kg], each >= 0.
  Vector3 added_inertia = Vector3::Zero();  ///< [kg m^2], each >= 0.
  Vector3 rotational_drag = Vector3::Zero();     ///< c [N m s^2], each >= 0: M_i = -c_i |w| w_i.
  Vector3 center_of_buoyancy = Vector3::Zero();  ///< from the centre of mass [m].
  Vector3 force = Vector3::Zero();               ///< [N], constant, world frame, at the centre of mass.
  Vector3 attachment = Vector3::Zero();          ///< of the tether, from the centre of mass [m].
  Vector3 wind_area = Vector3::Zero();           ///< CdA in air [m^2], each >= 0.
  std::optional<Hull> hull;
};

/// Every bound of RigidBody that `body` violates, one sentence each, beginning with `prefix`.
std::vector<std::string> validate(const RigidBody& body, const std::string& prefix = "vehicle.");

/// Simulated bodies at the tether's ends; an end without one is held on a given path.
struct EndBodies
{
  std::optional<RigidBody> vessel;
  std::optional<RigidBody> vehicle;
};

}  // namespace tether_monitor::core
