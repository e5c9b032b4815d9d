#pragma once

#include "elementary_functions.h"
#include "tether_monitor/core/kernel/kernel.h"

// Motion of the water in a sea, (M21) of doc/model.md, at W points at once; WaveField::at does the same for one.

namespace tether_monitor::core::kernel
{
constexpr int WAVES_AT_ONCE = 64;  // whose sines are kept from the sum of the surface to that of the motion

template <int W>
TM_INLINE SineCosine<W> sineCosineOf(const WaveConstants& wave, typename Simd<W>::Vector x,
                                     typename Simd<W>::Vector y, double time)
{
  const double k_x = wave.wavenumber * wave.direction_x, k_y = wave.wavenumber * wave.direction_y;
  return sineCosine<W>(k_x * x + k_y * y + (wave.phase - wave.frequency * time));
}

// Height to which the motion dies away.
template <int W>
TM_INLINE typename Simd<W>::Vector profileHeight(const WaveBlock& in, typename Simd<W>::Vector z,
                                                 typename Simd<W>::Vector surface)
{
  using V = typename Simd<W>::Vector;
  const V zero{}, floor = broadcast<W>(-in.depth);
  if (!in.is_stretched)
    return lanes::max(lanes::min(z, zero), floor);
  const V below = lanes::min(z - surface, zero);
  return __builtin_isinf(in.depth) ? below : lanes::max(below / (1.0 + surface / in.depth), floor);
}

template <int W>
TM_INLINE void addWave(const WaveConstants& wave, double depth, typename Simd<W>::Vector z,
                       const SineCosine<W>& angle, typename Simd<W>::Vector (&u)[3],
                       typename Simd<W>::Vector (&a)[3])
{
  using V = typename Simd<W>::Vector;
  const V kz = wave.wavenumber * z, least = broadcast<W>(WaveConstants::NO_MOTION);
  const auto moves = kz >= least;
  if (!any(moves))
    return;
  const V deep = wave.speed * exponential<W>(lanes::max(kz, least));
  V mirror{};
  if (!__builtin_isinf(depth))
    mirror = wave.speed * exponential<W>(lanes::max(-kz - 2.0 * wave.wavenumber * depth, 2.0 * least));
  const V horizontal = moves ? deep + mirror : V{}, up = moves ? deep - mirror : V{};
  const V ahead = horizontal * angle.cosine, ahead_rate = wave.frequency * horizontal * angle.sine;
  u[0] += wave.direction_x * ahead;
  u[1] += wave.direction_y * ahead;
  u[2] += up * angle.sine;
  a[0] += wave.direction_x * ahead_rate;
  a[1] += wave.direction_y * ahead_rate;
  a[2] -= wave.frequency * up * angle.cosine;
}

template <int W>
TM_INLINE void waveKernel(const WaveBlock& in, int first)
{
  using V = typename Simd<W>::Vector;
  const V x = load<W>(in.x + first), y = load<W>(in.y + first);
  const int kept_count = in.waves_count < WAVES_AT_ONCE ? in.waves_count : WAVES_AT_ONCE;
  SineCosine<W> kept[WAVES_AT_ONCE];
  V surface{};
  for (int i = 0; i < in.waves_count; ++i)
  {
    const SineCosine<W> angle = sineCosineOf<W>(in.waves[i], x, y, in.time);
    surface += in.waves[i].amplitude * angle.cosine;
    if (i < kept_count)
      kept[i] = angle;
  }
  const V z = profileHeight<W>(in, load<W>(in.z + first), surface);
  V u[3], a[3]{};
  for (int k = 0; k < 3; ++k)
    u[k] = load<W>(in.velocity + k * BLOCK + first);
  for (int i = 0; i < in.waves_count; ++i)
    addWave<W>(in.waves[i], in.depth, z, i < kept_count ? kept[i] : sineCosineOf<W>(in.waves[i], x, y, in.time), u,
               a);
  for (int k = 0; k < 3; ++k)
  {
    store<W>(in.velocity + k * BLOCK + first, u[k]);
    store<W>(in.acceleration + k * BLOCK + first, a[k]);
  }
  store<W>(in.surface + first, surface);
}

template <int W>
void wavesKernel(const WaveBlock& in)
{
  for (int first = 0; first < in.count; first += W)
    waveKernel<W>(in, first);
}
}  // namespace tether_monitor::core::kernel
