#include "tether_monitor/monitor/ensemble/ensemble_summary.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tether_monitor/monitor/ensemble/random_numbers.h"

namespace tether_monitor::monitor
{
TEST(Distribution, OfManyNormalNumbersIsNormal)
{
  Eigen::RowVectorXd x(4000);
  RandomNumbers random(2);
  for (int i = 0; i < x.size(); ++i)
    x[i] = 100.0 + 8.0 * random.normal();
  const Distribution d = distributionOf(x, 6.0);
  EXPECT_NEAR(d.median, 100.0, 0.5);
  EXPECT_NEAR(d.stddev, 10.0, 0.3);
  EXPECT_NEAR(d.p95, 100.0 + 16.45, 0.7) << "what every member is unsure of adds in quadrature";
  EXPECT_NEAR(d.p05, 100.0 - 16.45, 0.7);
}

TEST(Distribution, ASkewedOneStaysSkewed)
{
  Eigen::RowVectorXd x(1000);
  for (int i = 0; i < x.size(); ++i)
    x[i] = std::pow((i + 0.5) / 1000.0, 2);  // a tension goes with the square of the current
  const Distribution d = distributionOf(x, 0.0);
  EXPECT_NEAR(d.median, 0.25, 1e-3);
  EXPECT_NEAR(d.p05, 0.0025, 1e-3);
  EXPECT_NEAR(d.p95, 0.9025, 1e-3);
  EXPECT_GT(d.p95 - d.median, 2.0 * (d.median - d.p05));
  EXPECT_NEAR(d.stddev, std::sqrt(1.0 / 5.0 - 2.0 * 0.25 / 3.0 + 0.25 * 0.25), 1e-3) << "about what is published";
}
}  // namespace tether_monitor::monitor
