#pragma once

// Vectors of W doubles, one broadcastLane for each of W elements, or W rows of a column. Everything here is a
// template on W and lives in one instruction set's translation unit: see kernel.h.

#include "tether_monitor/core/base/lane_math.h"

namespace tether_monitor::core::kernel
{
using lanes::any;
using lanes::dot;
template <int W>
struct Simd
{
  static constexpr int WIDTH = W;
  typedef double Vector __attribute__((vector_size(8 * W)));
  typedef long long Mask __attribute__((vector_size(8 * W)));
};

#ifdef __clang__
#define TM_SHUFFLE(W, a, b, ...) __builtin_shufflevector(a, b, __VA_ARGS__)
#else
#define TM_SHUFFLE(W, a, b, ...) __builtin_shuffle(a, b, typename Simd<W>::Mask{__VA_ARGS__})
#endif
#define TM_INLINE TETHER_MONITOR_INLINE

// A copy of bytes, which is one unaligned load: GCC 10 forgets the alignment of a typedef that depends on W.
template <int W>
TM_INLINE typename Simd<W>::Vector load(const double* p)
{
  typename Simd<W>::Vector x;
  __builtin_memcpy(&x, p, sizeof(x));
  return x;
}

template <int W>
TM_INLINE void store(double* p, typename Simd<W>::Vector x)
{
  __builtin_memcpy(p, &x, sizeof(x));
}

template <int W>
TM_INLINE typename Simd<W>::Vector broadcast(double x)
{
  return lanes::broadcast<typename Simd<W>::Vector>(x);
}

// W rows of W numbers become W columns.
template <int W, class V>
TM_INLINE void transpose(V* r)
{
  if constexpr (W == 2)
  {
    const V a = TM_SHUFFLE(W, r[0], r[1], 0, 2), b = TM_SHUFFLE(W, r[0], r[1], 1, 3);
    r[0] = a;
    r[1] = b;
  }
  else if constexpr (W == 4)
  {
    const V a = TM_SHUFFLE(W, r[0], r[1], 0, 4, 2, 6), b = TM_SHUFFLE(W, r[0], r[1], 1, 5, 3, 7);
    const V c = TM_SHUFFLE(W, r[2], r[3], 0, 4, 2, 6), d = TM_SHUFFLE(W, r[2], r[3], 1, 5, 3, 7);
    r[0] = TM_SHUFFLE(W, a, c, 0, 1, 4, 5);
    r[1] = TM_SHUFFLE(W, b, d, 0, 1, 4, 5);
    r[2] = TM_SHUFFLE(W, a, c, 2, 3, 6, 7);
    r[3] = TM_SHUFFLE(W, b, d, 2, 3, 6, 7);
  }
  else
  {
    V even[4], odd[4], quad[8];
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i)
    {
      even[i] = TM_SHUFFLE(W, r[2 * i], r[2 * i + 1], 0, 8, 2, 10, 4, 12, 6, 14);
      odd[i] = TM_SHUFFLE(W, r[2 * i], r[2 * i + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
#pragma GCC unroll 2
    for (int half = 0; half < 2; ++half)
    {
      quad[4 * half] = TM_SHUFFLE(W, even[2 * half], even[2 * half + 1], 0, 1, 8, 9, 4, 5, 12, 13);
      quad[4 * half + 1] = TM_SHUFFLE(W, odd[2 * half], odd[2 * half + 1], 0, 1, 8, 9, 4, 5, 12, 13);
      quad[4 * half + 2] = TM_SHUFFLE(W, even[2 * half], even[2 * half + 1], 2, 3, 10, 11, 6, 7, 14, 15);
      quad[4 * half + 3] = TM_SHUFFLE(W, odd[2 * half], odd[2 * half + 1], 2, 3, 10, 11, 6, 7, 14, 15);
    }
#pragma GCC unroll 4
    for (int i = 0; i < 4; ++i)
    {
      r[i] = TM_SHUFFLE(W, quad[i], quad[4 + i], 0, 1, 2, 3, 8, 9, 10, 11);
      r[4 + i] = TM_SHUFFLE(W, quad[i], quad[4 + i], 4, 5, 6, 7, 12, 13, 14, 15);
    }
  }
}

// Rows of eight numbers, `stride` apart in memory, of W elements: out[k] has number k of every element, k < 6.
// Reads eight numbers a row.
template <int W, class V>
TM_INLINE void gather(const double* base, int stride, V* out)
{
  constexpr int PIECES = W >= 8 ? 1 : 6 / W + (6 % W != 0);
#pragma GCC unroll 3
  for (int piece = 0; piece < PIECES; ++piece)
  {
    V rows[W];
#pragma GCC unroll 8
    for (int i = 0; i < W; ++i)
      rows[i] = load<W>(base + i * stride + piece * W);
    transpose<W>(rows);
#pragma GCC unroll 8
    for (int k = 0; k < W; ++k)
      if (piece * W + k < 6)
        out[piece * W + k] = rows[k];
  }
}

// The reverse: `count` rows of eight numbers, `stride` apart; the last two become zero. `add_first` adds to what
// the first row holds.
template <int W, class V>
TM_INLINE void scatter(const V* in, double* out, int stride, int count, bool add_first = false)
{
#pragma GCC unroll 4
  for (int piece = 0; piece < 8 / W; ++piece)
  {
    V rows[W];
#pragma GCC unroll 8
    for (int k = 0; k < W; ++k)
      rows[k] = piece * W + k < 6 ? in[piece * W + k] : V{};
    transpose<W>(rows);
    double* to = out + piece * W;
    if (add_first)
      rows[0] += load<W>(to);
    if (count == W)
    {
#pragma GCC unroll 8
      for (int i = 0; i < W; ++i)
        store<W>(to + i * stride, rows[i]);
    }
    else
    {
#pragma GCC unroll 8
      for (int i = 0; i < W; ++i)
        if (i < count)
          store<W>(to + i * stride, rows[i]);
    }
  }
}

// What an element takes over from its neighbour before it: broadcastLane i of the answer is broadcastLane i - 1,
// broadcastLane 0 is zero.
template <int W, class V>
TM_INLINE V shiftIn(V x)
{
  if constexpr (W == 2)
    return TM_SHUFFLE(W, V{}, x, 0, 2);
  else if constexpr (W == 4)
    return TM_SHUFFLE(W, V{}, x, 0, 4, 5, 6);
  else
    return TM_SHUFFLE(W, V{}, x, 0, 8, 9, 10, 11, 12, 13, 14);
}
}  // namespace tether_monitor::core::kernel
