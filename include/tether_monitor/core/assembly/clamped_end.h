#pragma once

#include "tether_monitor/core/base/tangent_weights.h"
#include "tether_monitor/core/linalg/block_tridiagonal.h"

namespace tether_monitor::core
{
/**
 * An end that is clamped: the tether leaves it in a given direction.
 *
 * Model: (M31) of doc/model.md, a spring that turns the slope into the direction, ten thousand times as stiff as
 * the tether's bending over the element at the end: U = K (1 - cos angle), K = 1e4 EI / l.
 */
struct ClampedEnd
{
  double stiffness;   ///< K [N m].
  Vector3 direction;  ///< unit vector along growing s; zero: hinged.

  bool isHinged() const { return direction.isZero(); }
  /// Energy [J] at a node's slope.
  double energy(const Vector3& slope) const;
  /// Couple on the slope that the clamp needs: dU/d slope [N m].
  Vector3 residual(const Vector3& slope) const;
  Matrix3 tangent(const Vector3& slope) const;
  /// Moment that the tether exerts on what holds the end, world axes [N m].
  Vector3 moment(const Vector3& slope) const;
};

}  // namespace tether_monitor::core
