#include "tether_monitor/core/linalg/block_tridiagonal.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "tether_monitor/core/kernel/kernel.h"

namespace tether_monitor::core
{
namespace
{
// A random matrix, the same as a dense one, and a right-hand side.
struct RandomSystem
{
  BlockTridiagonal matrix;
  Eigen::MatrixXd dense;
  NodeField b;
  Eigen::VectorXd expected;

  explicit RandomSystem(int nodes, unsigned seed) : matrix(nodes), b(nodes)
  {
    std::mt19937 g(seed);
    std::uniform_real_distribution<double> x(-1.0, 1.0);
    dense = Eigen::MatrixXd::Zero(6 * nodes, 6 * nodes);
    for (int i = 0; i + 1 < nodes; ++i)
    {
      ElementMatrix m = ElementMatrix::NullaryExpr([&] { return x(g); });
      m.diagonal().array() += 6.0;
      matrix.addElement(i, m);
      dense.block<12, 12>(6 * i, 6 * i) += m;
    }
    matrix.imposeRow(0, 1);
    dense.row(1).setZero();
    dense(1, 1) = 1.0;
    Eigen::VectorXd rhs(6 * nodes);
    for (int i = 0; i < nodes; ++i)
    {
      b[i] = NodeCoords::NullaryExpr([&] { return x(g); });
      rhs.segment<6>(6 * i) = b[i];
    }
    expected = dense.partialPivLu().solve(rhs);
  }
  double error() const
  {
    double largest = 0.0;
    for (std::size_t i = 0; i < b.size(); ++i)
      largest = std::max(largest, (b[i] - expected.segment<6>(6 * i)).norm());
    return largest;
  }
};
}  // namespace

TEST(BlockTridiagonal, EveryKernelSolvesAsADenseSolver)
{
  for (const kernel::Kernel* kernel : kernel::available())
    for (int nodes = 2; nodes < 12; ++nodes)
    {
      RandomSystem system(nodes, 5 + nodes);
      ASSERT_TRUE(system.matrix.solve(kernel->solve, system.b)) << kernel->name;
      EXPECT_LT(system.error(), 1e-10) << kernel->name << ", " << nodes << " nodes";
    }
}

TEST(BlockTridiagonal, PivotedSolvesAsADenseSolver)
{
  RandomSystem system(9, 5);
  ASSERT_TRUE(system.matrix.solvePivoted(system.b));
  EXPECT_LT(system.error(), 1e-10);
}

TEST(BlockTridiagonal, SolvesAgainWithTheSameFactors)
{
  RandomSystem system(9, 6);
  NodeField first = system.b, again = system.b;
  ASSERT_TRUE(system.matrix.solvePivoted(first));
  system.matrix.solveWithFactors(again);
  for (int i = 0; i < 9; ++i)
    EXPECT_LT((first[i] - again[i]).norm(), 1e-12);
}

TEST(BlockTridiagonal, ReportsASingularMatrix)
{
  BlockTridiagonal matrix(3);
  for (const kernel::Kernel* kernel : kernel::available())
  {
    NodeField b(3, NodeCoords::Ones());
    EXPECT_FALSE(matrix.solve(kernel->solve, b)) << kernel->name;
  }
  NodeField b(3, NodeCoords::Ones());
  EXPECT_FALSE(matrix.solvePivoted(b));
}

TEST(BlockTridiagonal, ReportsANumberThatIsNotFinite)
{
  for (const kernel::Kernel* kernel : kernel::available())
    for (int node = 0; node < 5; ++node)
    {
      RandomSystem system(5, 7);
      system.b[node][2] = std::numeric_limits<double>::quiet_NaN();
      EXPECT_FALSE(system.matrix.solve(kernel->solve, system.b)) << kernel->name << ", node " << node;
    }
}

TEST(BlockTridiagonal, RefusesFewerThanTwoNodes)
{
  EXPECT_THROW(BlockTridiagonal(1), std::invalid_argument);
}

}  // namespace tether_monitor::core
