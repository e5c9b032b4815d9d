#pragma once

#include <Eigen/LU>
#include <vector>

#include "tether_monitor/core/linalg/block_tridiagonal.h"

namespace tether_monitor::core
{
/// Couples obstacles that have a mass to the tether: the iteration matrix is bordered by three rows and columns
/// for each. All memory is taken by the constructor.
class BorderedSystem
{
 public:
  using Column = Eigen::Matrix<double, 6, 3>;

  BorderedSystem() = default;
  /// @param movable  for every obstacle, whether it has a mass.
  BorderedSystem(const std::vector<bool>& movable, int nodes);

  void setZero();
  /// Whether obstacle `k` has a place in the border.
  bool has(int k) const { return place_[k] >= 0; }

  /// Residual of obstacle k: the force that it must receive from outside [N]; and its own block of the matrix.
  Vector3& residual(int k) { return residual_[place_[k]]; }
  Matrix3& diagonal(int k) { return diagonal_[place_[k]]; }
  /// Derivative of a node's residual with respect to obstacle k.
  Column& column(int k, int node) { return columns_[place_[k]][node]; }
  /// Transpose of the derivative of the residual of obstacle k with respect to a node.
  Column& row(int k, int node) { return rows_[place_[k]][node]; }
  /// Change of obstacle k after solve().
  Vector3 solution(int k) const { return solution_.segment<3>(3 * place_[k]); }

  /**
   * Solves the bordered system. Destroys matrix and border.
   *
   * @param b  in: right-hand side of the nodes, out: their solution.
   * @return   false if a pivot is singular or a number is not finite.
   */
  bool solve(BlockTridiagonal& matrix, NodeField& b);

 private:
  std::vector<int> place_;  // in the border, -1: none
  std::vector<std::vector<Column>> columns_, rows_;
  std::vector<Matrix3> diagonal_;
  std::vector<Vector3> residual_;
  Eigen::MatrixXd schur_;
  Eigen::VectorXd solution_, work_;
  Eigen::PartialPivLU<Eigen::MatrixXd> lu_;
};

}  // namespace tether_monitor::core
