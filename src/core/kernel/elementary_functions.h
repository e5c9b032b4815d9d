#pragma once

#include "simd.h"

// Sine, cosine and exponential of W numbers at once, to a few units in the last place: reduction of the argument
// with a constant in parts (Cody and Waite), polynomials of the Cephes library (S. Moshier) for sine and cosine,
// Taylor's series for the exponential.

namespace tether_monitor::core::kernel
{
constexpr double ROUNDING = 6755399441055744.0;  // 1.5 * 2^52: a sum with it ends in the integer that is nearest

template <int W>
struct SineCosine
{
  typename Simd<W>::Vector sine, cosine;
};

/// @param x  [rad], up to 1e8.
template <int W, class V>
TM_INLINE SineCosine<W> sineCosine(V x)
{
  using Mask = typename Simd<W>::Mask;
  constexpr double QUARTER[3] = {1.57079625129699707031, 7.54978941586159635336e-8, 5.39030285815811905290e-15};
  const V rounded = x * 0.63661977236758134308 + ROUNDING;
  const Mask quarter = reinterpret_cast<Mask>(rounded);
  const V n = rounded - ROUNDING;
  const V r = ((x - n * QUARTER[0]) - n * QUARTER[1]) - n * QUARTER[2];
  const V s = r * r;
  const V sine =
      r +
      r * s *
          (((((1.58962301576546568060e-10 * s - 2.50507477628578072866e-8) * s + 2.75573136213857245213e-6) * s -
             1.98412698295895385996e-4) *
                s +
            8.33333333332211858878e-3) *
               s -
           1.66666666666666307295e-1);
  const V cosine =
      1.0 - 0.5 * s +
      s * s *
          (((((-1.13585365213876817300e-11 * s + 2.08757008419747316778e-9) * s - 2.75573141792967388112e-7) * s +
             2.48015872888517045348e-5) *
                s -
            1.38888888888730564116e-3) *
               s +
           4.16666666666665929218e-2);
  const Mask is_swapped = (quarter & 1) != 0;
  const V first = is_swapped ? cosine : sine, second = is_swapped ? sine : cosine;
  const Mask sign_of_sine = (quarter & 2) << 62, sign_of_cosine = ((quarter + 1) & 2) << 62;
  return {reinterpret_cast<V>(reinterpret_cast<Mask>(first) ^ sign_of_sine),
          reinterpret_cast<V>(reinterpret_cast<Mask>(second) ^ sign_of_cosine)};
}

/// @param x  -700..700.
template <int W, class V>
TM_INLINE V exponential(V x)
{
  using Mask = typename Simd<W>::Mask;
  constexpr double LN2[2] = {6.93145751953125e-1, 1.42860682030941723212e-6};
  constexpr double TAYLOR[] = {
      1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800, 1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720,
      1.0 / 120,       1.0 / 24,       1.0 / 6,       0.5,          1.0,         1.0};
  const V rounded = x * 1.44269504088896340736 + ROUNDING;
  const V n = rounded - ROUNDING;
  const V r = (x - n * LN2[0]) - n * LN2[1];
  V sum = broadcast<W>(TAYLOR[0]);
#pragma GCC unroll 12
  for (int i = 1; i < 13; ++i)
    sum = sum * r + TAYLOR[i];
  const Mask power = (reinterpret_cast<Mask>(rounded) + 1023) << 52;
  return sum * reinterpret_cast<V>(power);
}
}  // namespace tether_monitor::core::kernel
