#include "tether_monitor/core/element/hermite_shape_functions.h"

#include <gtest/gtest.h>

#include "tether_monitor/core/element/element_matrices.h"

namespace tether_monitor::core
{
TEST(ShapeFunctions, TakeTheNodalValuesAtTheNodes)
{
  const double L = 3.0;
  EXPECT_EQ(shapeFunctions(0.0, L), (ShapeValues{1.0, 0.0, 0.0, 0.0}));
  EXPECT_EQ(shapeFunctions(1.0, L), (ShapeValues{0.0, 0.0, 1.0, 0.0}));
  EXPECT_EQ(shapeSlopes(0.0, L), (ShapeValues{0.0, 1.0, 0.0, 0.0}));
  EXPECT_EQ(shapeSlopes(1.0, L), (ShapeValues{0.0, 0.0, 0.0, 1.0}));
}

TEST(ShapeFunctions, DerivativesAreThoseOfTheFunctions)
{
  const double L = 2.5, h = 1e-6;
  for (double xi : {0.1, 0.37, 0.5, 0.9})
    for (int i = 0; i < 4; ++i)
    {
      const double first = (shapeFunctions(xi + h, L)[i] - shapeFunctions(xi - h, L)[i]) / (2.0 * h * L);
      const double second = (shapeSlopes(xi + h, L)[i] - shapeSlopes(xi - h, L)[i]) / (2.0 * h * L);
      EXPECT_NEAR(shapeSlopes(xi, L)[i], first, 1e-8) << "function " << i << " at " << xi;
      EXPECT_NEAR(shapeCurvatures(xi, L)[i], second, 1e-8) << "function " << i << " at " << xi;
    }
}

TEST(ElementMatrices, AreTheIntegralsOfTheShapeFunctions)
{
  const double L = 1.7;
  const int steps = 4000;  // midpoint rule: error below 1e-6
  ShapeMatrix mass = ShapeMatrix::Zero(), bending = ShapeMatrix::Zero();
  for (int k = 0; k < steps; ++k)
  {
    const double xi = (k + 0.5) / steps;
    const ShapeValues S = shapeFunctions(xi, L), C = shapeCurvatures(xi, L);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
      {
        mass(i, j) += S[i] * S[j] * L / steps;
        bending(i, j) += C[i] * C[j] * L / steps;
      }
  }
  EXPECT_LT((mass - massMatrix(L)).norm(), 1e-6);
  EXPECT_LT((bending - bendingMatrix(L)).norm(), 1e-6 * bending.norm());
}

}  // namespace tether_monitor::core
