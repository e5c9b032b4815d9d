#pragma once

namespace tether_monitor::core::kernel
{
constexpr int COLUMN = 8;           ///< numbers from one column of a 6 x 6 block to the next.
constexpr int MATRIX = 6 * COLUMN;  ///< numbers of a 6 x 6 block; rows 6 and 7 of its columns are zero.

/// A block-tridiagonal system of 6 x 6 blocks.
struct BlockSystem
{
  int nodes;  ///< >= 2.
  const double *diagonal, *upper, *lower;
  double* b;        ///< in: right-hand side, six numbers a node; out: solution.
  double* scratch;  ///< nodes x (MATRIX + COLUMN) numbers, aligned to 64 bytes.
};

/// Elimination from both ends, without pivoting. Returns false if a pivot is lost or a number is not finite; b is
/// then unusable.
using BlockSolveKernel = bool (*)(const BlockSystem&);

}  // namespace tether_monitor::core::kernel
