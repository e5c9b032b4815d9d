#include "tether_monitor/files/cubic_spline.h"

#include <gtest/gtest.h>

namespace tether_monitor::files
{
TEST(Spline, ReproducesACubicOnUnevenKnots)
{
  const auto cubic = [](double t) { return core::Vector3(t * t * t - t, 2.0 * t * t, 1.0 - t); };
  const auto slope = [](double t) { return core::Vector3(3.0 * t * t - 1.0, 4.0 * t, -1.0); };
  const std::vector<double> t{0.0, 0.3, 1.0, 1.1, 2.5, 3.0};
  std::vector<core::Vector3> x;
  for (double time : t)
    x.push_back(cubic(time));
  const auto v = files::splineVelocities(t, x);
  for (std::size_t i = 0; i < t.size(); ++i)
    EXPECT_LT((v[i] - slope(t[i])).norm(), 1e-10) << "knot " << i;
}

TEST(Spline, FewPointsGiveThePolynomialThroughThem)
{
  EXPECT_LT((files::splineVelocities({0, 2}, {{0, 0, 0}, {1, 0, 0}})[1] - core::Vector3(0.5, 0, 0)).norm(), 1e-15);
  const auto v = files::splineVelocities({0, 1, 2}, {{0, 0, 0}, {1, 0, 0}, {4, 0, 0}});
  EXPECT_NEAR(v[0].x(), 0.0, 1e-14);
  EXPECT_NEAR(v[2].x(), 4.0, 1e-14);
}

}  // namespace tether_monitor::files
