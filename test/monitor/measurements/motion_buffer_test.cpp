#include "tether_monitor/monitor/measurements/motion_buffer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
using core::Vector3;
const Eigen::Quaterniond LEVEL = Eigen::Quaterniond::Identity();

TEST(MotionBuffer, RefusesWhatIsNoPose)
{
  MotionBuffer track;
  EXPECT_EQ(track.addPose(1.0, {NAN, 0, 0}, LEVEL), Rejection::NOT_FINITE);
  EXPECT_EQ(track.addPose(NAN, {0, 0, 0}, LEVEL), Rejection::NOT_FINITE);
  EXPECT_EQ(track.addPose(1.0, {0, 0, 0}, Eigen::Quaterniond(0, 0, 0, 0)), Rejection::BAD_QUATERNION);
  EXPECT_EQ(track.addPose(1.0, {0, 0, 0}, Eigen::Quaterniond(NAN, 0, 0, 0)), Rejection::NOT_FINITE);
  EXPECT_FALSE(track.hasPose());
  EXPECT_EQ(track.addPose(1.0, {0, 0, 0}, LEVEL), Rejection::NONE);
  EXPECT_EQ(track.addPose(1.0, {0, 0, 0}, LEVEL), Rejection::OUT_OF_ORDER);
  EXPECT_EQ(track.addPose(0.5, {0, 0, 0}, LEVEL), Rejection::OUT_OF_ORDER);
  EXPECT_EQ(track.addTwist(1.0, {0, INFINITY, 0}, Vector3::Zero()), Rejection::NOT_FINITE);
}

TEST(MotionBuffer, InterpolatesASmoothMotionWithMeasuredRates)
{
  MotionBuffer track;
  for (double t = 0.0; t < 2.05; t += 0.1)
  {
    track.addPose(t, {std::sin(t), 0, 0}, LEVEL);
    track.addTwist(t, {std::cos(t), 0, 0}, Vector3::Zero());
  }
  const BodyState at = track.at(1.234);
  EXPECT_NEAR(at.position.x(), std::sin(1.234), 1e-6);
  EXPECT_NEAR(at.velocity.x(), std::cos(1.234), 1e-4);
}

TEST(MotionBuffer, ExtrapolatesWithTheMeasuredVelocityAndKnowsItsAge)
{
  MotionBuffer track;
  track.addPose(10.0, {1, 2, 3}, LEVEL);
  track.addTwist(10.0, {2, 0, -1}, Vector3::Zero());
  EXPECT_NEAR(track.at(10.5).position.x(), 2.0, 1e-12);
  EXPECT_NEAR(track.at(10.5).position.z(), 2.5, 1e-12);
  EXPECT_DOUBLE_EQ(track.age(10.5), 0.5);
  EXPECT_TRUE(std::isinf(track.age(9.0)));
}

TEST(MotionBuffer, FindsTheVelocityThatNobodyMeasuresFromThePoses)
{
  MotionBuffer track;
  for (int i = 0; i <= 40; ++i)
    track.addPose(0.01 * i, {0.5 * 0.01 * i + 0.002 * (i % 2 ? 1 : -1), 0, 0}, LEVEL);
  EXPECT_NEAR(track.at(0.4).velocity.x(), 0.5, 0.02) << "2 mm of noise must not become 0.2 m/s";
}

TEST(MotionBuffer, TurnsTheLeverWithTheBody)
{
  MotionBuffer track;
  const double rate = 0.5;
  for (int i = 0; i <= 10; ++i)
    track.addPose(0.1 * i, {0, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(rate * 0.1 * i, Vector3::UnitZ())));
  const core::EndMotion point = track.at(0.55).attachmentPoint({2, 0, 0});
  EXPECT_NEAR(point.position.x(), 2.0 * std::cos(0.275), 1e-6);
  EXPECT_NEAR(point.position.y(), 2.0 * std::sin(0.275), 1e-6);
  EXPECT_NEAR(point.velocity.x(), -std::sin(0.275), 1e-6);
  EXPECT_NEAR(point.velocity.y(), std::cos(0.275), 1e-6);
  // Beyond the last pose the turn goes on.
  EXPECT_NEAR(track.at(1.2).attachmentPoint({2, 0, 0}).position.y(), 2.0 * std::sin(0.6), 1e-3);
}

TEST(MotionBuffer, AttitudesThatComeByThemselvesAreTheOrientation)
{
  MotionBuffer track;
  const auto yaw = [](double angle) { return Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3::UnitZ())); };
  EXPECT_FALSE(track.hasOrientation());
  EXPECT_EQ(track.addAttitude(0.0, Eigen::Quaterniond(0, 0, 0, 0)), Rejection::BAD_QUATERNION);
  EXPECT_EQ(track.addAttitude(0.0, yaw(0.0), Vector3(NAN, 0, 0)), Rejection::NOT_FINITE);
  for (double t = 0.0; t < 1.05; t += 0.1)
    ASSERT_EQ(track.addAttitude(t, yaw(0.3 * t)), Rejection::NONE);
  EXPECT_EQ(track.addAttitude(0.5, yaw(0.0)), Rejection::OUT_OF_ORDER);
  EXPECT_FALSE(track.hasPose());
  EXPECT_TRUE(track.hasOrientation());
  track.addPose(0.0, {0, 0, 0}, LEVEL);
  track.addPose(1.0, {1, 0, 0}, LEVEL);
  EXPECT_LT(track.at(0.55).orientation.angularDistance(yaw(0.165)), 1e-9);
  EXPECT_NEAR(track.at(0.55).angular_velocity.z(), 0.3, 1e-9);
  EXPECT_NEAR(track.at(0.55).position.x(), 0.55, 1e-9);
  EXPECT_LT(track.at(1.2).orientation.angularDistance(yaw(0.36)), 1e-6) << "goes on turning";
  EXPECT_LT(track.at(1.8).orientation.angularDistance(LEVEL), 1e-9) << "too old";
}

TEST(MotionBuffer, ForgetsTheOldestWhenFull)
{
  MotionBuffer track;
  for (int i = 0; i < 3000; ++i)
    ASSERT_EQ(track.addPose(i, {1.0 * i, 0, 0}, LEVEL), Rejection::NONE);
  EXPECT_NEAR(track.at(2998.5).position.x(), 2998.5, 1e-9);
}

}  // namespace tether_monitor::monitor
