#include "tether_monitor/monitor/measurements/measured_vector.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
TEST(MeasuredVector, SaysOfEveryAxisWhatIsKnown)
{
  MeasuredVector v = MeasuredVector::withStddev({1.0, 2.0, 3.0}, {0.1, 0.2, 0.3});
  v.setNotMeasured(0);
  v.setUnspecified(1);
  EXPECT_FALSE(v.isMeasured(0));
  EXPECT_EQ(v.accuracy(1), Accuracy::UNSPECIFIED);
  EXPECT_DOUBLE_EQ(v.stddev(2), 0.3);
  EXPECT_FALSE(v.isComplete());
  EXPECT_FALSE(v.isEmpty());
  EXPECT_TRUE(MeasuredVector().isEmpty());
  EXPECT_TRUE(MeasuredVector(core::Vector3::Ones()).isComplete());
}

TEST(MeasuredVector, ADefaultFillsOnlyWhatIsUnspecified)
{
  MeasuredVector v = MeasuredVector::withStddev({1.0, 2.0, 3.0}, {0.1, 0.2, 0.3});
  v.setUnspecified(1);
  v.setNotMeasured(2);
  const MeasuredVector filled = v.withDefaultStddev(5.0);
  EXPECT_DOUBLE_EQ(filled.stddev(0), 0.1);
  EXPECT_DOUBLE_EQ(filled.stddev(1), 5.0);
  EXPECT_FALSE(filled.isMeasured(2));
}

TEST(MeasuredVector, KeepsCorrelationsUntilAnAxisIsTakenOut)
{
  core::Matrix3 covariance;
  covariance << 1.0, 0.5, 0.1, 0.5, 2.0, 0.2, 0.1, 0.2, 3.0;
  MeasuredVector v(core::Vector3::Zero(), covariance);
  EXPECT_EQ(v.at(core::Vector3::Ones()).covariance(), covariance);
  v.setNotMeasured(1);
  EXPECT_EQ(v.covariance()(0, 1), 0.0);
  EXPECT_EQ(v.covariance()(0, 2), 0.1);
}

TEST(MeasuredVector, IsNotValidWithNonsense)
{
  EXPECT_TRUE(MeasuredVector(core::Vector3::Ones()).isValid());
  EXPECT_FALSE(MeasuredVector(core::Vector3(1.0, NAN, 0.0)).isValid());
  EXPECT_FALSE(MeasuredVector::withStddev(core::Vector3::Zero(), {1.0, 0.0, 1.0}).isValid());
  core::Matrix3 covariance = core::Matrix3::Identity();
  covariance(0, 1) = covariance(1, 0) = 1.5;
  EXPECT_FALSE(MeasuredVector(core::Vector3::Zero(), covariance).isValid()) << "a correlation above 1";
  covariance << 1.0, 0.9, -0.9, 0.9, 1.0, 0.9, -0.9, 0.9, 1.0;
  EXPECT_FALSE(MeasuredVector(core::Vector3::Zero(), covariance).isValid()) << "indefinite";
  MeasuredVector partial(core::Vector3(1.0, NAN, 0.0));
  partial.setNotMeasured(1);
  EXPECT_TRUE(partial.isValid());
}

}  // namespace tether_monitor::monitor
