#include "tether_monitor/ros/geometry_conversions.h"

#include <gtest/gtest.h>

namespace tether_monitor
{
TEST(Quaternion, KeepsItsOrder)
{
  geometry_msgs::Quaternion q;
  q.x = 0.1, q.y = 0.2, q.z = 0.3, q.w = 0.9;
  EXPECT_EQ(quaternion(q).x(), 0.1);
  EXPECT_EQ(quaternion(q).w(), 0.9);
}

TEST(MeasuredVectorOfAMessage, HasItsWholeCovarianceInTheAxesOfTheWorld)
{
  core::Matrix3 covariance;
  covariance << 4.0, 1.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 9.0;
  const Eigen::Isometry3d quarter_turn(Eigen::AngleAxisd(M_PI / 2.0, core::Vector3::UnitZ()));
  const monitor::MeasuredVector v = measuredVector({1.0, 2.0, 3.0}, covariance, quarter_turn, NOT_MEASURED_STDDEV);
  core::Matrix3 turned;
  turned << 1.0, -1.0, 0.0, -1.0, 4.0, 0.0, 0.0, 0.0, 9.0;
  EXPECT_LT((v.covariance() - turned).norm(), 1e-12);
  EXPECT_LT((v.value() - core::Vector3(-2.0, 1.0, 3.0)).norm(), 1e-12);
}

TEST(MeasuredVectorOfAMessage, ZeroOfOneAxisLeavesTheOthersAsTheyAre)
{
  const core::Vector3 variance(0.0, 0.25, -1.0);
  const monitor::MeasuredVector v = measuredVector(core::Vector3::Ones(), variance.asDiagonal(),
                                                   Eigen::Isometry3d::Identity(), NOT_MEASURED_STDDEV);
  EXPECT_EQ(v.accuracy(0), monitor::Accuracy::UNSPECIFIED);
  EXPECT_EQ(v.accuracy(1), monitor::Accuracy::SPECIFIED);
  EXPECT_EQ(v.accuracy(2), monitor::Accuracy::UNSPECIFIED);
  EXPECT_DOUBLE_EQ(v.stddev(1), 0.5);
}

TEST(MeasuredVectorOfAMessage, AHundredMetresIsNotMeasuredAndLessIs)
{
  const core::Vector3 variance(1e4, 9999.0, 1e9);
  const monitor::MeasuredVector v = measuredVector(core::Vector3::Ones(), variance.asDiagonal(),
                                                   Eigen::Isometry3d::Identity(), NOT_MEASURED_STDDEV);
  EXPECT_FALSE(v.isMeasured(0));
  EXPECT_TRUE(v.isMeasured(1));
  EXPECT_FALSE(v.isMeasured(2));
}

TEST(MeasuredVectorOfAMessage, ATurnSpreadsWhatWasNotMeasured)
{
  const core::Vector3 variance(1e6, 0.01, 0.01);
  const Eigen::Isometry3d eighth(Eigen::AngleAxisd(M_PI / 4.0, core::Vector3::UnitZ()));
  const monitor::MeasuredVector v =
      measuredVector(core::Vector3::Ones(), variance.asDiagonal(), eighth, NOT_MEASURED_STDDEV);
  EXPECT_FALSE(v.isMeasured(0));
  EXPECT_FALSE(v.isMeasured(1));
  EXPECT_NEAR(v.stddev(2), 0.1, 1e-12);
}

}  // namespace tether_monitor
