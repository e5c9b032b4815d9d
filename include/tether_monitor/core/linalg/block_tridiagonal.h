#pragma once

#include <Eigen/LU>
#include <vector>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/core/kernel/block_solve_kernel.h"

namespace tether_monitor::core
{
/// A 6 x 6 block inside a BlockTridiagonal.
using NodeBlock = Eigen::Map<NodeMatrix, Eigen::Unaligned, Eigen::OuterStride<kernel::COLUMN>>;
using ConstNodeBlock = Eigen::Map<const NodeMatrix, Eigen::Unaligned, Eigen::OuterStride<kernel::COLUMN>>;

/// Block-tridiagonal matrix of 6 x 6 blocks with direct solvers. All memory is taken by the constructor.
class BlockTridiagonal
{
 public:
  /// @param nodes  number of block rows, >= 2.
  explicit BlockTridiagonal(int nodes);

  int nodes() const { return static_cast<int>(diagonal_.size()); }

  void setZero();
  /// Adds the 12 x 12 matrix of element `i` to block rows i and i + 1.
  void addElement(int i, const ElementMatrix& m);

  NodeBlock diagonal(int i) { return NodeBlock(diagonal_[i].x); }
  ConstNodeBlock diagonal(int i) const { return ConstNodeBlock(diagonal_[i].x); }
  /// Block in row i, column i + 1.
  NodeBlock upper(int i) { return NodeBlock(upper_[i].x); }
  ConstNodeBlock upper(int i) const { return ConstNodeBlock(upper_[i].x); }
  /// Block in row i + 1, column i.
  NodeBlock lower(int i) { return NodeBlock(lower_[i].x); }
  ConstNodeBlock lower(int i) const { return ConstNodeBlock(lower_[i].x); }

  /// Replaces row `row` (0..5) of block row `node` by the identity: the unknown there is known.
  void imposeRow(int node, int row);

  /**
   * Solves A x = b by block elimination from both ends, without pivoting: for matrices that inertia or a metric
   * keeps definite. The matrix stays.
   *
   * @param b  in: right-hand side, out: solution. Size nodes().
   * @return   false if a pivot is lost or a number is not finite; b is then unusable.
   */
  bool solve(kernel::BlockSolveKernel kernel, NodeField& b);

  /// As solve(), with partial pivoting within the blocks; the factors stay for solveWithFactors().
  bool solvePivoted(NodeField& b);

  /// After solvePivoted(): solves for right-hand sides of six rows and any number of columns at each node.
  template <typename Columns>
  void solveWithFactors(std::vector<Columns>& b) const;

  /// For the kernels: where the blocks begin.
  double* diagonalData(int i) { return diagonal_[i].x; }
  double* upperData(int i) { return upper_[i].x; }
  double* lowerData(int i) { return lower_[i].x; }

 private:
  struct alignas(64) Block
  {
    double x[kernel::MATRIX];
  };
  struct alignas(64) Scratch
  {
    double x[kernel::MATRIX + kernel::COLUMN];
  };

  std::vector<Block> diagonal_, upper_, lower_;
  std::vector<Scratch> scratch_;
  std::vector<Eigen::PartialPivLU<NodeMatrix>> pivots_;  // of the reduced diagonal blocks
  std::vector<NodeMatrix> ahead_;                        // inverse of them times the upper blocks
};

template <typename Columns>
void BlockTridiagonal::solveWithFactors(std::vector<Columns>& b) const
{
  const int n = nodes();
  for (int i = 0; i < n; ++i)
  {
    if (i > 0)
      b[i].noalias() -= lower(i - 1) * b[i - 1];
    b[i] = pivots_[i].solve(b[i]).eval();
  }
  for (int i = n - 2; i >= 0; --i)
    b[i].noalias() -= ahead_[i] * b[i + 1];
}

}  // namespace tether_monitor::core
