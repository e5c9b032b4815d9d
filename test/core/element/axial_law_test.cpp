#include "tether_monitor/core/element/axial_law.h"

#include <gtest/gtest.h>

namespace tether_monitor::core
{
const AxialParameters LAW{1.0e6, 0.0, 10.0, 1e-5};

TEST(AxialLaw, IsLinearInPull)
{
  const AxialLaw at = axialLaw(LAW, 0.02);
  EXPECT_DOUBLE_EQ(at.force, 2.0e4);
  EXPECT_DOUBLE_EQ(at.modulus, 1.0e6);
  EXPECT_DOUBLE_EQ(at.energy, 200.0);
}

TEST(AxialLaw, IsForceFreeAtRest)
{
  EXPECT_EQ(axialLaw(LAW, 0.0).force, 0.0);
  EXPECT_EQ(axialLaw(LAW, 0.0).energy, 0.0);
}

TEST(AxialLaw, CarriesNoMoreThanTheLimitAndTheResidualInPush)
{
  for (double eps : {-1e-5, -1e-4, -1e-3, -1e-2, -0.4})
  {
    const double force = axialLaw(LAW, eps).force;
    EXPECT_LT(force, 0.0);
    EXPECT_GT(force, -LAW.compression_limit + LAW.residual * LAW.stiffness * eps) << eps;
  }
}

TEST(AxialLaw, ForceAndModulusAreDerivativesAndContinuous)
{
  for (double eps : {-0.1, -1e-3, -2e-5, -1e-6, 3e-6, 1e-2})
  {
    const double h = 1e-4 * std::abs(eps);
    const AxialLaw at = axialLaw(LAW, eps);
    EXPECT_NEAR(at.force, (axialLaw(LAW, eps + h).energy - axialLaw(LAW, eps - h).energy) / (2.0 * h),
                1e-6 * std::abs(at.force));
    EXPECT_NEAR(at.modulus, (axialLaw(LAW, eps + h).force - axialLaw(LAW, eps - h).force) / (2.0 * h),
                1e-6 * at.modulus);
    EXPECT_GE(at.modulus, LAW.residual * LAW.stiffness);
  }
  EXPECT_NEAR(axialLaw(LAW, -1e-12).modulus, LAW.stiffness, 1.0);
}

}  // namespace tether_monitor::core
