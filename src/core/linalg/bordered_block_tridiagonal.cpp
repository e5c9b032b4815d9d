#include "tether_monitor/core/linalg/bordered_block_tridiagonal.h"

namespace tether_monitor::core
{
BorderedSystem::BorderedSystem(const std::vector<bool>& movable, int nodes)
{
  int count = 0;
  for (const bool has_mass : movable)
    place_.push_back(has_mass ? count++ : -1);
  columns_.assign(count, std::vector<Column>(nodes, Column::Zero()));
  rows_ = columns_;
  diagonal_.assign(count, Matrix3::Zero());
  residual_.assign(count, Vector3::Zero());
  schur_ = Eigen::MatrixXd::Zero(3 * count, 3 * count);
  solution_ = work_ = Eigen::VectorXd::Zero(3 * count);
  lu_ = Eigen::PartialPivLU<Eigen::MatrixXd>(3 * count);
}

void BorderedSystem::setZero()
{
  for (auto* fields : {&columns_, &rows_})
    for (std::vector<Column>& field : *fields)
      for (Column& entry : field)
        entry.setZero();
  for (Matrix3& block : diagonal_)
    block.setZero();
  for (Vector3& force : residual_)
    force.setZero();
}

bool BorderedSystem::solve(BlockTridiagonal& matrix, NodeField& b)
{
  if (!matrix.solvePivoted(b))
    return false;
  const std::size_t count = diagonal_.size();
  for (std::vector<Column>& column : columns_)
    matrix.solveWithFactors(column);
  for (std::size_t k = 0; k < count; ++k)
  {
    solution_.segment<3>(3 * k) = residual_[k];
    for (std::size_t i = 0; i < b.size(); ++i)
      solution_.segment<3>(3 * k) -= rows_[k][i].transpose() * b[i];
    for (std::size_t m = 0; m < count; ++m)
    {
      Matrix3 block = k == m ? diagonal_[k] : Matrix3(Matrix3::Zero());
      for (std::size_t i = 0; i < b.size(); ++i)
        block -= rows_[k][i].transpose() * columns_[m][i];
      schur_.block<3, 3>(3 * k, 3 * m) = block;
    }
  }
  lu_.compute(schur_);
  work_ = solution_;
  solution_ = lu_.solve(work_);
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < b.size(); ++i)
      b[i] -= columns_[k][i] * solution_.segment<3>(3 * k);
  return solution_.allFinite();
}

}  // namespace tether_monitor::core
