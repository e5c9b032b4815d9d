#include "tether_monitor/core/element/axial_law.h"

#include <gtest/gtest.h>

namespace tether_monitor::core
{
const AxialParameters LAW{1.0e6, 0.0, 10.0, 1e-5};

TEST(AxialLaw, IsLinearInPull)
{
  const AxialResponse<double> at = axialResponse(LAW, 0.02);
  EXPECT_DOUBLE_EQ(at.force, 2.0e4);
  EXPECT_DOUBLE_EQ(at.modulus, 1.0e6);
  EXPECT_DOUBLE_EQ(axialEnergy(LAW, 0.02), 200.0);
}

TEST(AxialLaw, IsForceFreeAtRest)
{
  EXPECT_EQ(axialResponse(LAW, 0.0).force, 0.0);
  EXPECT_EQ(axialEnergy(LAW, 0.0), 0.0);
}

TEST(AxialLaw, CarriesNoMoreThanTheLimitAndTheResidualInPush)
{
  for (double eps : {-1e-5, -1e-4, -1e-3, -1e-2, -0.4})
  {
    const double force = axialResponse(LAW, eps).force;
    EXPECT_LT(force, 0.0);
    EXPECT_GT(force, -LAW.compression_limit + LAW.compression_stiffness_ratio * LAW.stiffness * eps) << eps;
  }
}

TEST(AxialLaw, ForceAndModulusAreDerivativesAndContinuous)
{
  for (double eps : {-0.1, -1e-3, -2e-5, -1e-6, 3e-6, 1e-2})
  {
    const double h = 1e-4 * std::abs(eps);
    const AxialResponse<double> at = axialResponse(LAW, eps);
    EXPECT_NEAR(at.force, (axialEnergy(LAW, eps + h) - axialEnergy(LAW, eps - h)) / (2.0 * h),
                1e-6 * std::abs(at.force));
    EXPECT_NEAR(at.modulus, (axialResponse(LAW, eps + h).force - axialResponse(LAW, eps - h).force) / (2.0 * h),
                1e-6 * at.modulus);
    EXPECT_GE(at.modulus, LAW.compression_stiffness_ratio * LAW.stiffness);
  }
  EXPECT_NEAR(axialResponse(LAW, -1e-12).modulus, LAW.stiffness, 1.0);
}

}  // namespace tether_monitor::core
