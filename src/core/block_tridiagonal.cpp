#include "tether_monitor/core/block_tridiagonal.h"

#include <Eigen/Dense>
#include <stdexcept>

namespace tether_monitor::core
{
BlockTridiagonal::BlockTridiagonal(int nodes)
{
  if (nodes < 2)
    throw std::invalid_argument("BlockTridiagonal: nodes = " + std::to_string(nodes) + " (must be >= 2)");
  diagonal_.resize(nodes);
  upper_.resize(nodes - 1);
  lower_.resize(nodes - 1);
  setZero();
}

void BlockTridiagonal::setZero()
{
  for (NodeMatrix& block : diagonal_)
    block.setZero();
  for (NodeMatrix& block : upper_)
    block.setZero();
  for (NodeMatrix& block : lower_)
    block.setZero();
}

void BlockTridiagonal::addElement(int i, const ElementMatrix& m)
{
  diagonal_[i] += m.topLeftCorner<6, 6>();
  upper_[i] += m.topRightCorner<6, 6>();
  lower_[i] += m.bottomLeftCorner<6, 6>();
  diagonal_[i + 1] += m.bottomRightCorner<6, 6>();
}

void BlockTridiagonal::holdRow(int node, int row)
{
  diagonal_[node].row(row).setZero();
  diagonal_[node](row, row) = 1.0;
  if (node > 0)
    lower_[node - 1].row(row).setZero();
  if (node + 1 < nodes())
    upper_[node].row(row).setZero();
}

bool BlockTridiagonal::solve(NodeField& b)
{
  const int n = nodes();
  for (int i = 0; i < n; ++i)
  {
    const Eigen::PartialPivLU<NodeMatrix> lu(diagonal_[i]);
    b[i] = lu.solve(b[i]).eval();
    if (!b[i].allFinite())
      return false;
    if (i + 1 == n)
      break;
    upper_[i] = lu.solve(upper_[i]).eval();
    diagonal_[i + 1].noalias() -= lower_[i] * upper_[i];
    b[i + 1].noalias() -= lower_[i] * b[i];
  }
  for (int i = n - 2; i >= 0; --i)
  {
    b[i].noalias() -= upper_[i] * b[i + 1];
    if (!b[i].allFinite())
      return false;
  }
  return true;
}

}  // namespace tether_monitor::core
