#include "tether_monitor/core/cable/axial_stiffening.h"

#include <gtest/gtest.h>

#include "tether_monitor/core/element/axial_law.h"

namespace tether_monitor::core
{
namespace
{
// A polyamide rope that stiffens, and gives a little at the end.
const std::vector<StrainTension> ROPE{{0.05, 200.0}, {0.15, 1500.0}, {0.25, 6000.0}, {0.28, 6500.0}};

AxialParameters law()
{
  const AxialCurve curve = axialCurve(ROPE);
  return {curve.stiffness, 0.0, 5.0, 1e-5, curve.stiffening};
}

double tensionAt(double elongation)
{
  return (1.0 + elongation) * axialResponse(law(), strainOfStretch(1.0 + elongation)).force;
}
}  // namespace

TEST(AxialStiffening, TheCurvePassesThroughEveryRow)
{
  for (const StrainTension& row : ROPE)
    EXPECT_NEAR(tensionAt(row.strain), row.tension, 1e-9 * row.tension);
  EXPECT_EQ(tensionAt(0.0), 0.0);
}

TEST(AxialStiffening, GoesOnAsBeforeTheLastRow)
{
  const auto modulusAt = [](double e) { return axialResponse(law(), strainOfStretch(1.0 + e)).modulus; };
  EXPECT_DOUBLE_EQ(modulusAt(0.27), modulusAt(0.4));
  EXPECT_NEAR(law().largestModulus(), modulusAt(0.2), 1e-6);
}

TEST(AxialStiffening, ForceIsTheDerivativeOfTheEnergy)
{
  const double h = 1e-6;
  for (const double eps : {-0.01, 0.03, 0.1, 0.2, 0.3, 0.6})
  {
    const double force = (axialEnergy(law(), eps + h) - axialEnergy(law(), eps - h)) / (2.0 * h);
    EXPECT_NEAR(axialResponse(law(), eps).force, force, 1e-6 * law().largestModulus()) << eps;
    const double modulus = (axialResponse(law(), eps + h).force - axialResponse(law(), eps - h).force) / (2.0 * h);
    EXPECT_NEAR(axialResponse(law(), eps).modulus, modulus, 1e-5 * law().largestModulus()) << eps;
  }
}

TEST(AxialStiffening, TheStretchOfATensionIsItsInverse)
{
  for (const double elongation : {0.0, 1e-9, 0.01, 0.05, 0.1, 0.15, 0.2, 0.26, 0.28, 0.5, 3.0})
    EXPECT_NEAR(stretchAtTension(law(), tensionAt(elongation)), 1.0 + elongation, 1e-12) << elongation;
  EXPECT_EQ(stretchAtTension(law(), -10.0), 1.0);
}

TEST(AxialStiffening, ARowThatARopeCannotHaveIsNamed)
{
  EXPECT_TRUE(validate(ROPE).empty());
  const auto fault = [](const std::vector<StrainTension>& rows)
  {
    const std::vector<std::string> problems = validate(rows);
    return problems.size() == 1 ? problems.front() : std::to_string(problems.size()) + " problems";
  };
  EXPECT_EQ(fault({}), "a curve of strain and tension has 1 to 8 rows, not 0");
  EXPECT_EQ(fault({{0.0, 0.0}, {0.1, 5.0}}), "row 1: strain must be greater than 0");
  EXPECT_EQ(fault({{0.1, 5.0}, {0.1, 6.0}}), "row 2: strain must be greater than in the row before");
  EXPECT_EQ(fault({{0.1, 5.0}, {0.2, 5.0}}), "row 2: tension must be greater than in the row before");
  EXPECT_EQ(fault({{0.1, 100.0}, {0.5, 110.0}}),
            "row 2: tension over (1 + strain) must grow, or the rope gives way");
  EXPECT_EQ(fault({{0.1, NAN}}), "row 1: tension must be greater than 0");
  std::vector<StrainTension> many;
  for (int i = 1; i <= 9; ++i)
    many.push_back({0.1 * i, 100.0 * i});
  EXPECT_EQ(fault(many), "a curve of strain and tension has 1 to 8 rows, not 9");
}

}  // namespace tether_monitor::core
