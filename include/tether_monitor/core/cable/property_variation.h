#pragma once

#include <algorithm>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/**
 * By what one tether of an ensemble differs from the model that all share, its water and its vehicle included.
 * Default: by nothing.
 */
struct PropertyVariation
{
  double drag_normal = 1.0;           ///< factor on Cn [-], > 0.
  double drag_tangential = 1.0;       ///< factor on Ct [-], > 0.
  double mass_per_length = 1.0;       ///< factor on the dry mass [-], > 0; the weight in water follows.
  double axial_stiffness = 1.0;       ///< factor on EA and on its curve [-], > 0.
  double length = 1.0;                ///< factor on the length without load [-], > 0; s and the mass stay.
  double vehicle_drag = 1.0;          ///< factor on the vehicle's drag areas [-], > 0.
  Vector3 current = Vector3::Zero();  ///< of the water, beyond that of the environment [m/s], at the surface.
  Vector3 shear = Vector3::Zero();    ///< its change per metre of depth [1/s].
  double shear_depth = 0.0;           ///< down to which [m], >= 0; deeper the current is the same.

  /// What is to be added to the velocity of the water at height z [m/s].
  Vector3 currentAt(double z) const { return current + std::clamp(-z, 0.0, shear_depth) * shear; }
  /// True if the elements of both are the same.
  bool hasSameElements(const PropertyVariation& other) const
  {
    return drag_normal == other.drag_normal && drag_tangential == other.drag_tangential &&
           mass_per_length == other.mass_per_length && axial_stiffness == other.axial_stiffness &&
           length == other.length;
  }
  /// True if every number is one that a tether can have.
  bool isValid() const
  {
    const auto is_factor = [](double x) { return x > 0.0 && x < 1e3; };
    return is_factor(drag_normal) && is_factor(drag_tangential) && is_factor(mass_per_length) &&
           is_factor(axial_stiffness) && is_factor(length) && is_factor(vehicle_drag) && current.allFinite() &&
           shear.allFinite() && shear_depth >= 0.0 && shear_depth < 1e6;
  }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(drag_normal, drag_tangential, mass_per_length, axial_stiffness, length, vehicle_drag, current, shear,
      shear_depth);
  }
};

}  // namespace tether_monitor::core
