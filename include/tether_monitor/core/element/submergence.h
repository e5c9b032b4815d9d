#pragma once

#include "tether_monitor/core/base/lane_math.h"

namespace tether_monitor::core
{
/// Share of a piece of tether that is under water, and its derivative with depth. V is double or a vector of them.
template <class V>
struct Submergence
{
  V fraction;  ///< phi [-], 0 above the surface, 1 below it.
  V slope;     ///< -d phi / dz [1/m], >= 0.
};

/**
 * Submerged fraction of the piece of tether that one integration point stands for.
 *
 * Model: (M8) of doc/model.md. The piece spans the heights z +- extent/2; the fraction below the surface falls
 * from 1 to 0 in between, 1/2 - 3/4 x + 1/4 x^3 with x = 2 z / extent, without a kink at either end. So a tether
 * that pierces the surface feels the place of the waterline, not the place of the points.
 *
 * @param z       height of the point above the water surface [m].
 * @param extent  vertical extent of the piece [m], > 0.
 */
template <class V>
TETHER_MONITOR_INLINE Submergence<V> submergence(V z, V extent)
{
  const V x = lanes::min(lanes::max(2.0 * z / extent, lanes::broadcast<V>(-1.0)), lanes::broadcast<V>(1.0));
  return {0.5 + 0.25 * x * (x * x - 3.0), 1.5 * (1.0 - x * x) / extent};
}

}  // namespace tether_monitor::core
