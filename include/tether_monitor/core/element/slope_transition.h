#pragma once

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/element/axial_law.h"

namespace tether_monitor::core
{
/**
 * Where the axial stiffness jumps, at one end of the stiffer element: the tether carries one tension on both
 * sides, so it is stretched differently there. The node has the slope of the softer side; that of the stiffer
 * follows.
 *
 * Model: (M30) of doc/model.md. With x the stretch of the softer side over its natural one and y that of the
 * stiffer, y N(y) = x N(x) for x >= 1; below, where there is no tension, y = x (1 + (1 - rho)(1 - x)), which goes
 * on with the same value and the same derivative, rho the ratio of the stiffnesses at small strains. The direction
 * is the same on both sides.
 */
struct SlopeTransition
{
  bool active = false;
  AxialParameters softer;          ///< axial law of the softer side, at small strains.
  AxialParameters own;             ///< of this side.
  double neighbour_stretch = 1.0;  ///< natural stretch of the softer side [-].
  double own_stretch = 1.0;        ///< of this side [-].
};

/// The slope on the stiffer side as a function of the node's, s(g) = h(|g|) g, with its derivatives.
class SlopeMap
{
 public:
  /// @param node_slope  g [-].
  SlopeMap(const SlopeTransition& transition, const Vector3& node_slope);

  Vector3 slope() const { return h_ * g_; }
  /// ds/dt for dg/dt = `rate`; symmetric in what it is applied to: also the force on g of a force on s.
  Vector3 rate(const Vector3& rate) const;
  /// d2s/dt2 for the given rates of g.
  Vector3 acceleration(const Vector3& rate, const Vector3& acceleration) const;
  /// ds/dg.
  Matrix3 jacobian() const;
  /// Derivative of rate(force) with g, the force held: symmetric.
  Matrix3 geometricStiffness(const Vector3& force) const;

 private:
  Vector3 g_, unit_;
  double length_, h_, dh_, ddh_;  // |g|; h and its derivatives with it
};

}  // namespace tether_monitor::core
