#pragma once

#include "simd.h"

#include "tether_monitor/core/kernel/block_solve_kernel.h"

// Elimination of a block-tridiagonal system from both ends at once: two chains that do not wait for each other.
// Within a node Gauss-Jordan by columns, so that every update is a vector of rows.

namespace tether_monitor::core::kernel
{
// A column of six rows (and two zeros).
template <int W>
struct Column
{
  static constexpr int PACKS = W >= 6 ? 1 : (6 + W - 1) / W;
  typename Simd<W>::Vector x[PACKS];
};

template <int W>
TM_INLINE Column<W> loadColumn(const double* p)
{
  Column<W> c;
#pragma GCC unroll 3
  for (int i = 0; i < Column<W>::PACKS; ++i)
    c.x[i] = load<W>(p + i * W);
  return c;
}

template <int W>
TM_INLINE void storeColumn(double* p, const Column<W>& c)
{
#pragma GCC unroll 3
  for (int i = 0; i < Column<W>::PACKS; ++i)
    store<W>(p + i * W, c.x[i]);
}

template <int W>
TM_INLINE typename Simd<W>::Vector broadcastLane(const Column<W>& c, int row)
{
  using V = typename Simd<W>::Vector;
  const V pack = c.x[row / W];
  typename Simd<W>::Mask all{};
#ifdef __clang__
  return broadcast<W>(pack[row % W]);
  (void)all;
#else
  all += row % W;
  return __builtin_shuffle(pack, all);
#endif
}

template <int W>
TM_INLINE void subtract(Column<W>& c, const Column<W>& m, typename Simd<W>::Vector factor)
{
#pragma GCC unroll 3
  for (int i = 0; i < Column<W>::PACKS; ++i)
    c.x[i] -= factor * m.x[i];
}

// All bits of one broadcastLane.
template <int W>
TM_INLINE typename Simd<W>::Mask laneMask(int broadcastLane)
{
  typename Simd<W>::Mask m{};
  m[broadcastLane] = -1;
  return m;
}

template <int W>
TM_INLINE typename Simd<W>::Vector masked(typename Simd<W>::Vector x, typename Simd<W>::Mask m)
{
  return reinterpret_cast<typename Simd<W>::Vector>(reinterpret_cast<typename Simd<W>::Mask>(x) & m);
}

// One sweep: a node's block and right-hand side, with what the nodes eliminated before have taken off.
template <int W>
struct Sweep
{
  Column<W> D[6], b;
};

template <int W>
TM_INLINE Column<W> loadRight(const double* b)
{
  double copy[8] = {b[0], b[1], b[2], b[3], b[4], b[5], 0.0, 0.0};
  return loadColumn<W>(copy);
}

// Solves the nodes' blocks of SWEEPS chains for their right-hand sides and COLUMNS columns more, in step: while
// one waits for its pivot the other one works. Returns one, or NaN if a pivot is lost.
template <int W, int SWEEPS, int COLUMNS>
TM_INLINE typename Simd<W>::Vector eliminate(Sweep<W>* sweep, Column<W> (*more)[6])
{
  using V = typename Simd<W>::Vector;
  Column<W> inverse[SWEEPS] = {};
  V alive = broadcast<W>(1.0);
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k)
#pragma GCC unroll 2
    for (int n = 0; n < SWEEPS; ++n)
    {
      Sweep<W>& c = sweep[n];
      const V pivot = broadcastLane<W>(c.D[k], k), reciprocal = 1.0 / pivot;
      inverse[n].x[k / W] += masked<W>(reciprocal, laneMask<W>(k % W));
      Column<W> m = c.D[k];
      m.x[k / W] = masked<W>(m.x[k / W], ~laneMask<W>(k % W));
#pragma GCC unroll 3
      for (int i = 0; i < Column<W>::PACKS; ++i)
        m.x[i] *= reciprocal;
      alive *= reciprocal * pivot;
#pragma GCC unroll 6
      for (int j = k + 1; j < 6; ++j)
        subtract<W>(c.D[j], m, broadcastLane<W>(c.D[j], k));
      subtract<W>(c.b, m, broadcastLane<W>(c.b, k));
#pragma GCC unroll 6
      for (int j = 0; j < COLUMNS; ++j)
        subtract<W>(more[n][j], m, broadcastLane<W>(more[n][j], k));
    }
#pragma GCC unroll 2
  for (int n = 0; n < SWEEPS; ++n)
#pragma GCC unroll 3
    for (int i = 0; i < Column<W>::PACKS; ++i)
    {
      sweep[n].b.x[i] *= inverse[n].x[i];
#pragma GCC unroll 6
      for (int j = 0; j < COLUMNS; ++j)
        more[n][j].x[i] *= inverse[n].x[i];
    }
  return alive;
}

// A node to be eliminated: `right` couples its rows to the next node's unknowns, `left` the next node's rows to
// its own; `next` and `next_b` are the next node's.
struct Link
{
  const double *right, *left, *next, *next_b;
  double* stored;
};

template <int W, int SWEEPS>
TM_INLINE typename Simd<W>::Vector advance(Sweep<W>* sweep, const Link* link)
{
  using V = typename Simd<W>::Vector;
  Column<W> X[SWEEPS][6];
#pragma GCC unroll 2
  for (int n = 0; n < SWEEPS; ++n)
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j)
      X[n][j] = loadColumn<W>(link[n].right + j * COLUMN);
  const V alive = eliminate<W, SWEEPS, 6>(sweep, X);
#pragma GCC unroll 2
  for (int n = 0; n < SWEEPS; ++n)
  {
    Sweep<W>& c = sweep[n];
#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j)
      storeColumn<W>(link[n].stored + j * COLUMN, X[n][j]);
    storeColumn<W>(link[n].stored + MATRIX, c.b);

#pragma GCC unroll 6
    for (int j = 0; j < 6; ++j)
      c.D[j] = loadColumn<W>(link[n].next + j * COLUMN);
    Column<W> b = loadRight<W>(link[n].next_b);
#pragma GCC unroll 6
    for (int k = 0; k < 6; ++k)
    {
      const Column<W> m = loadColumn<W>(link[n].left + k * COLUMN);
      subtract<W>(b, m, broadcastLane<W>(c.b, k));
#pragma GCC unroll 6
      for (int j = 0; j < 6; ++j)
        subtract<W>(c.D[j], m, broadcastLane<W>(X[n][j], k));
    }
    c.b = b;
  }
  return alive;
}

template <int W>
TM_INLINE void substitute(const double* stored, Column<W>& x)
{
  Column<W> y = loadColumn<W>(stored + MATRIX), z{};
#pragma GCC unroll 3
  for (int k = 0; k < 3; ++k)
  {
    subtract<W>(y, loadColumn<W>(stored + 2 * k * COLUMN), broadcastLane<W>(x, 2 * k));
    subtract<W>(z, loadColumn<W>(stored + (2 * k + 1) * COLUMN), broadcastLane<W>(x, 2 * k + 1));
  }
#pragma GCC unroll 3
  for (int i = 0; i < Column<W>::PACKS; ++i)
    x.x[i] = y.x[i] + z.x[i];
}

template <int W>
TM_INLINE void storeRight(double* b, const Column<W>& x)
{
  double copy[8];
  storeColumn<W>(copy, x);
  for (int k = 0; k < 6; ++k)
    b[k] = copy[k];
}

// From the middle to both ends. @return zero if everything is finite.
template <int W>
TM_INLINE typename Simd<W>::Vector substituteFromMiddle(const BlockSystem& s, const Column<W>& at_middle)
{
  using V = typename Simd<W>::Vector;
  constexpr int STORED = MATRIX + COLUMN;
  const int last = s.nodes - 1, middle = s.nodes / 2;
  Column<W> x = at_middle, y = at_middle;
  V sum = x.x[0] - x.x[0];
  int i = middle - 1, j = middle + 1;
  while (i >= 0 || j <= last)
  {
    if (i >= 0)
    {
      substitute<W>(s.scratch + STORED * i, x);
      storeRight<W>(s.b + 6 * i, x);
      for (int p = 0; p < Column<W>::PACKS; ++p)
        sum += x.x[p] - x.x[p];
      --i;
    }
    if (j <= last)
    {
      substitute<W>(s.scratch + STORED * j, y);
      storeRight<W>(s.b + 6 * j, y);
      for (int p = 0; p < Column<W>::PACKS; ++p)
        sum += y.x[p] - y.x[p];
      ++j;
    }
  }
  return sum;
}

template <int W>
bool solveBlocks(const BlockSystem& s)
{
  using V = typename Simd<W>::Vector;
  constexpr int STORED = MATRIX + COLUMN;
  const int last = s.nodes - 1, middle = s.nodes / 2;
  Sweep<W> sweep[2];
  Sweep<W>&down = sweep[0], &up = sweep[1];
#pragma GCC unroll 6
  for (int j = 0; j < 6; ++j)
  {
    down.D[j] = loadColumn<W>(s.diagonal + j * COLUMN);
    up.D[j] = loadColumn<W>(s.diagonal + MATRIX * last + j * COLUMN);
  }
  down.b = loadRight<W>(s.b);
  up.b = loadRight<W>(s.b + 6 * last);

  // `down` goes 0, 1, ... to the middle, `up` last, last - 1, ... to it; `down` has a step more if the number of
  // nodes is even.
  V alive = broadcast<W>(1.0);
  int i = 0, j = last;
  const auto linkDown = [&]() -> Link
  {
    return {s.upper + MATRIX * i, s.lower + MATRIX * i, s.diagonal + MATRIX * (i + 1), s.b + 6 * (i + 1),
            s.scratch + STORED * i};
  };
  const auto linkUp = [&]() -> Link
  {
    return {s.lower + MATRIX * (j - 1), s.upper + MATRIX * (j - 1), s.diagonal + MATRIX * (j - 1),
            s.b + 6 * (j - 1), s.scratch + STORED * j};
  };
  for (; i < middle && j > middle; ++i, --j)
  {
    const Link links[2] = {linkDown(), linkUp()};
    alive *= advance<W, 2>(sweep, links);
  }
  if (i < middle)
  {
    const Link link = linkDown();
    alive *= advance<W, 1>(&down, &link);
  }

  // Both chains hold the middle's block: each less what its own side took off.
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k)
  {
    const Column<W> whole = loadColumn<W>(s.diagonal + MATRIX * middle + k * COLUMN);
    for (int p = 0; p < Column<W>::PACKS; ++p)
      down.D[k].x[p] += up.D[k].x[p] - whole.x[p];
  }
  const Column<W> whole = loadRight<W>(s.b + 6 * middle);
  for (int p = 0; p < Column<W>::PACKS; ++p)
    down.b.x[p] += up.b.x[p] - whole.x[p];
  alive *= eliminate<W, 1, 0>(&down, nullptr);
  storeRight<W>(s.b + 6 * middle, down.b);

  const V sum = substituteFromMiddle<W>(s, down.b);
  double finite = alive[0] - alive[0];
  for (int k = 0; k < W; ++k)
    finite += sum[k];
  return finite == 0.0;
}
}  // namespace tether_monitor::core::kernel
