#include "tether_monitor/core/block_tridiagonal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace tether_monitor::core
{
TEST(BlockTridiagonal, SolvesAsADenseSolver)
{
  std::mt19937 g(5);
  std::uniform_real_distribution<double> x(-1.0, 1.0);
  const int nodes = 9;
  BlockTridiagonal matrix(nodes);
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(6 * nodes, 6 * nodes);
  for (int i = 0; i + 1 < nodes; ++i)
  {
    ElementMatrix m = ElementMatrix::NullaryExpr([&] { return x(g); });
    m.diagonal().array() += 6.0;
    matrix.addElement(i, m);
    dense.block<12, 12>(6 * i, 6 * i) += m;
  }
  matrix.holdRow(0, 1);
  dense.row(1).setZero();
  dense(1, 1) = 1.0;
  NodeField b(nodes);
  Eigen::VectorXd rhs(6 * nodes);
  for (int i = 0; i < nodes; ++i)
  {
    b[i] = NodeCoords::NullaryExpr([&] { return x(g); });
    rhs.segment<6>(6 * i) = b[i];
  }
  ASSERT_TRUE(matrix.solve(b));
  const Eigen::VectorXd expected = dense.partialPivLu().solve(rhs);
  for (int i = 0; i < nodes; ++i)
    EXPECT_LT((b[i] - expected.segment<6>(6 * i)).norm(), 1e-10);
}

TEST(BlockTridiagonal, ReportsASingularMatrix)
{
  BlockTridiagonal matrix(3);
  NodeField b(3, NodeCoords::Ones());
  EXPECT_FALSE(matrix.solve(b));
}

TEST(BlockTridiagonal, RefusesFewerThanTwoNodes)
{
  EXPECT_THROW(BlockTridiagonal(1), std::invalid_argument);
}

}  // namespace tether_monitor::core
