#include "tether_monitor/core/element/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::core
{
TEST(Quadrature, WeightsAddUpToOneAndPointsLieSymmetrically)
{
  double loads = 0.0, axial = 2.0 * AXIAL_AT_NODES;
  for (const QuadraturePoint& point : QUADRATURE)
  {
    loads += point.weight;
    axial += point.axial;
  }
  EXPECT_NEAR(loads, 1.0, 1e-15);
  EXPECT_NEAR(axial, 1.0, 1e-15);
  EXPECT_NEAR(QUADRATURE[0].xi + QUADRATURE[2].xi, 1.0, 1e-15);
  EXPECT_EQ(QUADRATURE[1].xi, 0.5);
  EXPECT_EQ(QUADRATURE[0].weight, QUADRATURE[2].weight);
  EXPECT_EQ(QUADRATURE[0].axial, QUADRATURE[2].axial);
}

TEST(Quadrature, AxialEnergyIsExactToTheFifthDegreeAndNotBeyond)
{
  for (int degree = 0; degree <= 6; ++degree)
  {
    double sum = AXIAL_AT_NODES * (degree == 0 ? 2.0 : 1.0);
    for (const QuadraturePoint& point : QUADRATURE)
      sum += point.axial * std::pow(point.xi, degree);
    const double error = std::abs(sum - 1.0 / (degree + 1));
    if (degree <= 5)
    {
      EXPECT_LT(error, 1e-14) << degree;
    }
    else
    {
      EXPECT_GT(error, 1e-6) << degree;
    }
  }
}

TEST(Quadrature, LoadsAreExactToTheThirdDegree)
{
  for (int degree = 0; degree <= 3; ++degree)
  {
    double sum = 0.0;
    for (const QuadraturePoint& point : QUADRATURE)
      sum += point.weight * std::pow(point.xi, degree);
    EXPECT_NEAR(sum, 1.0 / (degree + 1), 1e-14) << degree;
  }
}
}  // namespace tether_monitor::core
