#pragma once

#include <Eigen/LU>
#include <vector>

#include "tether_monitor/core/types.h"

namespace tether_monitor::core
{
/// Block-tridiagonal matrix of 6 x 6 blocks with a direct solver. All memory is taken by the constructor.
class BlockTridiagonal
{
 public:
  /// @param nodes  number of block rows, >= 2.
  explicit BlockTridiagonal(int nodes);

  int nodes() const { return static_cast<int>(diagonal_.size()); }

  void setZero();
  /// Adds the 12 x 12 matrix of element `i` to block rows i and i + 1.
  void addElement(int i, const ElementMatrix& m);

  NodeMatrix& diagonal(int i) { return diagonal_[i]; }
  const NodeMatrix& diagonal(int i) const { return diagonal_[i]; }
  /// Block in row i, column i + 1.
  NodeMatrix& upper(int i) { return upper_[i]; }
  /// Block in row i + 1, column i.
  NodeMatrix& lower(int i) { return lower_[i]; }

  /// Replaces row `row` (0..5) of block row `node` by the identity: the unknown there is known.
  void holdRow(int node, int row);

  /**
   * Solves A x = b by block elimination without pivoting between blocks, partial pivoting within. Destroys the
   * matrix.
   *
   * @param b  in: right-hand side, out: solution. Size nodes().
   * @return   false if a pivot block is singular or a number is not finite; b is then unusable.
   */
  bool solve(NodeField& b);

  /// After solve(): solves for one more right-hand side, of six rows and any number of columns at each node.
  template <typename Columns>
  void solveAgain(std::vector<Columns>& b) const
  {
    const int n = nodes();
    for (int i = 0; i < n; ++i)
    {
      if (i > 0)
        b[i].noalias() -= lower_[i - 1] * b[i - 1];
      b[i] = diagonal_[i].partialPivLu().solve(b[i]).eval();
    }
    for (int i = n - 2; i >= 0; --i)
      b[i].noalias() -= upper_[i] * b[i + 1];
  }

 private:
  std::vector<NodeMatrix> diagonal_;
  std::vector<NodeMatrix> upper_;
  std::vector<NodeMatrix> lower_;
};

}  // namespace tether_monitor::core
