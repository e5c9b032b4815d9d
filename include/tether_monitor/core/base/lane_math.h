#pragma once

#ifdef __AVX__
#include <immintrin.h>
#endif

#include <type_traits>

/// Inlined wherever it is called: code of one instruction set must not be shared with another (see kernel.h).
#define TETHER_MONITOR_INLINE inline __attribute__((always_inline))

namespace tether_monitor::core::lanes
{
/**
 * Arithmetic that reads the same for a number and for a vector of numbers (a GCC vector type), one for each of
 * several elements: so a law is written once, for double and for the kernels.
 */
template <class V>
TETHER_MONITOR_INLINE V max(V a, V b)
{
  return a > b ? a : b;
}

template <class V>
TETHER_MONITOR_INLINE V min(V a, V b)
{
  return a < b ? a : b;
}

template <class V>
TETHER_MONITOR_INLINE V abs(V a)
{
  return a < 0.0 ? -a : a;
}

/// The number x in every lane.
template <class V>
TETHER_MONITOR_INLINE V broadcast(double x)
{
  return x - V{};
}

template <class V>
TETHER_MONITOR_INLINE V sqrt(V x)
{
  if constexpr (std::is_same_v<V, double>)
  {
    return __builtin_sqrt(x);
  }
  else
  {
#ifdef __AVX512F__
    if constexpr (sizeof(V) == 64)
      return reinterpret_cast<V>(_mm512_maskz_sqrt_pd(0xff, reinterpret_cast<__m512d>(x)));
#endif
#ifdef __AVX__
    if constexpr (sizeof(V) == 32)
      return reinterpret_cast<V>(_mm256_sqrt_pd(reinterpret_cast<__m256d>(x)));
#endif
    for (unsigned i = 0; i < sizeof(V) / sizeof(double); ++i)
      x[i] = __builtin_sqrt(x[i]);
    return x;
  }
}

/// True if a comparison holds in any lane.
TETHER_MONITOR_INLINE bool any(bool holds)
{
  return holds;
}
template <class Mask, std::enable_if_t<!std::is_same_v<Mask, bool>, int> = 0>
TETHER_MONITOR_INLINE bool any(Mask m)
{
  long long sum = 0;
  for (unsigned i = 0; i < sizeof(Mask) / sizeof(long long); ++i)
    sum |= m[i];
  return sum != 0;
}

template <class V>
TETHER_MONITOR_INLINE V dot(const V* a, const V* b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

}  // namespace tether_monitor::core::lanes
