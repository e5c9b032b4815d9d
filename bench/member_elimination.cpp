#include "bench/member_elimination.h"

#include <cstring>

namespace tether_monitor::bench
{
namespace
{
using Lanes = MemberElimination::Lanes;
using Node = MemberElimination::Node;

// A node's block, for what couples it to the next node and its right-hand side.
[[gnu::always_inline]] inline void eliminate(Node& n)
{
#pragma GCC unroll 6
  for (int k = 0; k < 6; ++k)
  {
    const Lanes reciprocal = 1.0 / n.diagonal[k][k];
#pragma GCC unroll 6
    for (int row = 0; row < 6; ++row)
    {
      if (row == k)
        continue;
      const Lanes factor = n.diagonal[row][k] * reciprocal;
#pragma GCC unroll 6
      for (int column = k + 1; column < 6; ++column)
        n.diagonal[row][column] -= factor * n.diagonal[k][column];
#pragma GCC unroll 6
      for (int column = 0; column < 6; ++column)
        n.upper[row][column] -= factor * n.upper[k][column];
      n.b[row] -= factor * n.b[k];
    }
#pragma GCC unroll 6
    for (int column = 0; column < 6; ++column)
      n.upper[k][column] *= reciprocal;
    n.b[k] *= reciprocal;
#pragma GCC unroll 6
    for (int column = k + 1; column < 6; ++column)
      n.diagonal[k][column] *= reciprocal;
  }
}

[[gnu::always_inline]] inline void solveAll(Node* nodes, int count)
{
  for (int i = 0; i < count; ++i)
  {
    Node& n = nodes[i];
    eliminate(n);
    if (i + 1 == count)
      break;
    Node& next = nodes[i + 1];
    for (int row = 0; row < 6; ++row)
    {
#pragma GCC unroll 6
      for (int column = 0; column < 6; ++column)
      {
        Lanes sum = next.diagonal[row][column];
#pragma GCC unroll 6
        for (int k = 0; k < 6; ++k)
          sum -= n.lower[row][k] * n.upper[k][column];
        next.diagonal[row][column] = sum;
      }
#pragma GCC unroll 6
      for (int k = 0; k < 6; ++k)
        next.b[row] -= n.lower[row][k] * n.b[k];
    }
  }
  for (int i = count - 2; i >= 0; --i)
#pragma GCC unroll 6
    for (int row = 0; row < 6; ++row)
#pragma GCC unroll 6
      for (int k = 0; k < 6; ++k)
        nodes[i].b[row] -= nodes[i].upper[row][k] * nodes[i + 1].b[k];
}

#ifdef __x86_64__
[[gnu::target("avx512f,avx512dq,fma")]] void solveWithAvx512(Node* nodes, int count)
{
  solveAll(nodes, count);
}

[[gnu::target("avx2,fma")]] void solveWithAvx2(Node* nodes, int count)
{
  solveAll(nodes, count);
}
#endif

void solvePortably(Node* nodes, int count)
{
  solveAll(nodes, count);
}
}  // namespace

void MemberElimination::set(int lane, const core::BlockTridiagonal& matrix, const core::NodeField& right)
{
  for (int i = 0; i < matrix.nodes(); ++i)
    for (int row = 0; row < 6; ++row)
    {
      nodes_[i].b[row][lane] = right[i][row];
      for (int column = 0; column < 6; ++column)
      {
        nodes_[i].diagonal[row][column][lane] = matrix.diagonal(i)(row, column);
        if (i + 1 == matrix.nodes())
          continue;
        nodes_[i].upper[row][column][lane] = matrix.upper(i)(row, column);
        nodes_[i].lower[row][column][lane] = matrix.lower(i)(row, column);
      }
    }
}

void MemberElimination::solve(const char* instructions)
{
  const int count = static_cast<int>(nodes_.size());
#ifdef __x86_64__
  if (std::strcmp(instructions, "avx512") == 0)
    return solveWithAvx512(nodes_.data(), count);
  if (std::strcmp(instructions, "avx2") == 0)
    return solveWithAvx2(nodes_.data(), count);
#endif
  (void)instructions;
  solvePortably(nodes_.data(), count);
}

core::NodeCoords MemberElimination::solution(int lane, int node) const
{
  core::NodeCoords x;
  for (int row = 0; row < 6; ++row)
    x[row] = nodes_[node].b[row][lane];
  return x;
}
}  // namespace tether_monitor::bench
