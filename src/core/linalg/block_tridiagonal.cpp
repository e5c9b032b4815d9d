#include "tether_monitor/core/linalg/block_tridiagonal.h"

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
  scratch_.resize(nodes);
  pivots_.resize(nodes);
  ahead_.resize(nodes - 1);
  setZero();
}

void BlockTridiagonal::setZero()
{
  for (std::vector<Block>* blocks : {&diagonal_, &upper_, &lower_})
    for (Block& block : *blocks)
      block = Block{};
}

void BlockTridiagonal::addElement(int i, const ElementMatrix& m)
{
  diagonal(i) += m.topLeftCorner<6, 6>();
  upper(i) += m.topRightCorner<6, 6>();
  lower(i) += m.bottomLeftCorner<6, 6>();
  diagonal(i + 1) += m.bottomRightCorner<6, 6>();
}

void BlockTridiagonal::imposeRow(int node, int row)
{
  diagonal(node).row(row).setZero();
  diagonal(node)(row, row) = 1.0;
  if (node > 0)
    lower(node - 1).row(row).setZero();
  if (node + 1 < nodes())
    upper(node).row(row).setZero();
}

bool BlockTridiagonal::solve(kernel::BlockSolveKernel kernel, NodeField& b)
{
  return kernel(
      {nodes(), diagonal_.front().x, upper_.front().x, lower_.front().x, b.front().data(), scratch_.front().x});
}

bool BlockTridiagonal::solvePivoted(NodeField& b)
{
  const int n = nodes();
  NodeMatrix reduced = diagonal(0);
  for (int i = 0; i < n; ++i)
  {
    pivots_[i].compute(reduced);
    b[i] = pivots_[i].solve(b[i]).eval();
    if (!b[i].allFinite())
      return false;
    if (i + 1 == n)
      break;
    ahead_[i] = pivots_[i].solve(upper(i));
    reduced = diagonal(i + 1);
    reduced.noalias() -= lower(i) * ahead_[i];
    b[i + 1].noalias() -= lower(i) * b[i];
  }
  for (int i = n - 2; i >= 0; --i)
  {
    b[i].noalias() -= ahead_[i] * b[i + 1];
    if (!b[i].allFinite())
      return false;
  }
  return true;
}

}  // namespace tether_monitor::core
