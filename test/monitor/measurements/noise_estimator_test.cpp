#include "tether_monitor/monitor/measurements/noise_estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tether_monitor::monitor
{
using Estimator = DifferenceNoiseEstimator;

TEST(DifferenceNoiseEstimator, MeasuresTheNoiseOnAMotion)
{
  for (const double stddev : {0.01, 0.3})
  {
    std::mt19937 generator(5);
    std::normal_distribution<double> normal(0.0, stddev);
    Estimator estimator;
    for (int i = 0; i < 400; ++i)
    {
      const double t = 0.1 * i;
      estimator.add(t, 2.0 * std::sin(0.7 * t) + 1.5 * t + normal(generator));
    }
    EXPECT_NEAR(estimator.stddev(), stddev, 0.25 * stddev);
    EXPECT_TRUE(estimator.isValid());
  }
}

TEST(DifferenceNoiseEstimator, AQuarticHasNoNoise)
{
  Estimator estimator;
  for (int i = 0; i < 50; ++i)
  {
    const double t = 0.1 * i;
    estimator.add(t, 1.0 + t * (2.0 + t * (-0.3 + t * (0.1 - 0.02 * t))));
  }
  EXPECT_EQ(estimator.stddev(), Estimator::LEAST);
}

TEST(DifferenceNoiseEstimator, AFewValuesTellNothing)
{
  Estimator estimator;
  for (int i = 0; i < 8; ++i)
  {
    estimator.add(i, i % 2);
    EXPECT_EQ(estimator.stddev(), Estimator::UNKNOWN) << i;
  }
  estimator.add(8.0, 0.0);
  // The fifth difference of 0 1 0 1 0 1 is 16; the squared mean over 252.
  EXPECT_NEAR(estimator.stddev(), 16.0 / std::sqrt(252.0), 1e-12);
}

TEST(DifferenceNoiseEstimator, AGapBeginsANewSeries)
{
  Estimator estimator;
  for (int i = 0; i < 5; ++i)
    estimator.add(0.1 * i, 0.0);
  for (int i = 0; i < 20; ++i)
    estimator.add(100.0 + 0.1 * i, 1000.0);
  EXPECT_EQ(estimator.stddev(), Estimator::LEAST) << "the step in between is no noise";
}
}  // namespace tether_monitor::monitor
