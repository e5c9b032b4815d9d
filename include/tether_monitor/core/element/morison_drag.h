#pragma once

#include "tether_monitor/core/base/lane_math.h"

namespace tether_monitor::core
{
/// Drag per unstretched metre and what its derivatives are made of. V is double or a vector of them.
template <class V>
struct MorisonDrag
{
  V force[3];         ///< [N/m], against the motion: what holds the body back is minus this.
  V normal_flow[3];   ///< un [m/s].
  V along;            ///< r' . u [m/s].
  V normal, tangent;  ///< 1/2 rho d Cn |un| and 1/2 rho d Ct |ut| [kg/(m s)].
  /// d force / d u = alpha I + beta r' r'^T + gamma un un^T.
  V alpha, beta, gamma;
};

/// Square of |r'| [-] below which a slope has no direction.
constexpr double NO_DIRECTION_SQUARED = 1e-24;

/**
 * Drag of a slender body moving through water.
 *
 * Model: f = 1/2 rho d (Cn |un| un + Ct |ut| ut), un and ut the parts of u normal and tangential to r', (M9) of
 * doc/model.md; Morison et al. (1950), independence principle. Both coefficients refer to diameter * length.
 *
 * @param normal          1/2 rho d Cn [kg/m^2], >= 0.
 * @param tangential      1/2 rho d Ct [kg/m^2], >= 0.
 * @param u               velocity of the body relative to the water [m/s], three components.
 * @param slope           r' [-]; only its direction counts.
 * @param inverse_square  1 / max(r'.r', NO_DIRECTION_SQUARED). A zero slope has no direction: all drag is normal.
 */
template <class V>
TETHER_MONITOR_INLINE MorisonDrag<V> morisonDrag(V normal, V tangential, const V* u, const V* slope,
                                                 V inverse_square)
{
  MorisonDrag<V> d;
  d.along = lanes::dot(slope, u);
  const V share = d.along * inverse_square;
  for (int k = 0; k < 3; ++k)
    d.normal_flow[k] = u[k] - share * slope[k];
  const V square = lanes::dot(d.normal_flow, d.normal_flow);
  d.normal = normal * lanes::sqrt(square);
  d.tangent = tangential * lanes::abs(d.along) * lanes::sqrt(inverse_square);
  for (int k = 0; k < 3; ++k)
    d.force[k] = d.normal * d.normal_flow[k] + d.tangent * share * slope[k];
  d.alpha = d.normal;
  d.beta = inverse_square * (2.0 * d.tangent - d.normal);
  d.gamma = d.normal / lanes::max(square, lanes::broadcast<V>(NO_DIRECTION_SQUARED));
  return d;
}

/// d force / d slope of the same, entry (row, column): the normal plane turns with the tether.
template <class V>
TETHER_MONITOR_INLINE V morisonDragSlopeTangent(const MorisonDrag<V>& d, const V* slope, V inverse_square, int row,
                                                int column)
{
  const V unit = row == column ? V{} + 1.0 : V{};
  const V plane = unit - inverse_square * slope[row] * slope[column];
  return inverse_square * (d.tangent * (2.0 * slope[row] * d.normal_flow[column] + d.along * plane) -
                           (d.normal * slope[row] * d.normal_flow[column] +
                            d.along * (d.normal * plane + d.gamma * d.normal_flow[row] * d.normal_flow[column])));
}

/// The force of morisonDrag() alone [N/m], for 3-vectors of numbers: minus the drag on the body.
template <class Vector3>
Vector3 morisonDragForce(double normal, double tangential, const Vector3& u, const Vector3& slope)
{
  const double inverse_square = 1.0 / lanes::max(slope.squaredNorm(), NO_DIRECTION_SQUARED);
  const MorisonDrag<double> drag = morisonDrag(normal, tangential, u.data(), slope.data(), inverse_square);
  return {drag.force[0], drag.force[1], drag.force[2]};
}

}  // namespace tether_monitor::core
