#pragma once

#include "simd.h"

namespace tether_monitor::core::kernel
{
// Coordinates, or rates, of W elements: r_a, l r'_a, r_b, l r'_b, three components each.
template <class V>
struct Coords
{
  V x[4][3];
};

// Where `count` < W elements are left, the last one stands for those that are missing.
template <int W>
TM_INLINE Coords<typename Simd<W>::Vector> coordsAt(const double* nodes, int count, bool may_overrun,
                                                    typename Simd<W>::Vector length)
{
  using V = typename Simd<W>::Vector;
  double copy[(W + 1) * 6 + 2];
  if (count < W || !may_overrun)
  {
    for (int i = 0; i <= W; ++i)
      for (int k = 0; k < 6; ++k)
        copy[6 * i + k] = nodes[6 * (i <= count ? i : count) + k];
    copy[6 * W + 6] = copy[6 * W + 7] = 0.0;
    nodes = copy;
  }
  Coords<V> out;
  V a[6], b[6];
  gather<W>(nodes, 6, a);
  gather<W>(nodes + 6, 6, b);
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    out.x[0][k] = a[k];
    out.x[1][k] = length * a[3 + k];
    out.x[2][k] = b[k];
    out.x[3][k] = length * b[3 + k];
  }
  return out;
}

template <class V>
TM_INLINE V at(const double (&shape)[4], const Coords<V>& e, int k)
{
  return shape[0] * e.x[0][k] + shape[1] * e.x[1][k] + shape[2] * e.x[2][k] + shape[3] * e.x[3][k];
}

// The slopes of the four functions add up to nothing for the two positions.
template <class V>
TM_INLINE V slopeAt(const double (&shape)[4], const Coords<V>& e, int k)
{
  return shape[2] * (e.x[2][k] - e.x[0][k]) + shape[1] * e.x[1][k] + shape[3] * e.x[3][k];
}

template <class V>
TM_INLINE V slopesAlone(const double (&shape)[4], const Coords<V>& e, int k)
{
  return shape[1] * e.x[1][k] + shape[3] * e.x[3][k];
}
}  // namespace tether_monitor::core::kernel
