#include "tether_monitor/monitor/estimator/tracked_body.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tether_monitor::monitor
{
PoseMeasurement poseAt(double t, const core::Vector3& position = core::Vector3::Zero())
{
  return {t, position};
}

TEST(TrackedBody, AVelocityThatWasNotMeasuredIsNotUsed)
{
  TrackedBody body(BodyConfig(), 1.0);
  const PoseMeasurement first = poseAt(0.0), second = poseAt(1.0, {1.0, 0.0, 0.0});
  TwistMeasurement rates{0.0, core::Vector3(50.0, 0.0, 0.0)};
  rates.velocity.setNotMeasured(1);
  EXPECT_EQ(body.add(&first, &rates), Rejection::NONE);
  rates.t = 1.0;
  EXPECT_EQ(body.add(&second, &rates), Rejection::NONE);
  EXPECT_NEAR(body.track().at(1.0).velocity.x(), 1.0, 1e-12) << "the slope of the poses";
}

TEST(TrackedBody, AMessageIsAcceptedAsAWholeOrNotAtAll)
{
  TrackedBody body(BodyConfig(), 1.0);
  const PoseMeasurement pose = poseAt(1.0);
  const TwistMeasurement bad{1.0, core::Vector3(NAN, 0.0, 0.0)}, good{1.0, core::Vector3(1.0, 0.0, 0.0)};
  EXPECT_EQ(body.add(&pose, &bad), Rejection::NOT_FINITE);
  EXPECT_FALSE(body.track().hasPose()) << "the pose of a refused message";
  EXPECT_EQ(body.add(nullptr, &good), Rejection::NONE);
  EXPECT_EQ(body.add(&pose, &good), Rejection::OUT_OF_ORDER) << "its rates are not later than the last";
  EXPECT_FALSE(body.track().hasPose());
}

TEST(TrackedBody, NeedsAWholePosition)
{
  TrackedBody body(BodyConfig(), 1.0);
  PoseMeasurement height = poseAt(1.0);
  height.position.setNotMeasured(0);
  EXPECT_EQ(body.add(&height, nullptr), Rejection::NOT_MEASURED);
}

TEST(TrackedBody, KeepsItsAttitudeWhereNoneWasMeasured)
{
  BodyConfig config;
  config.attachment = {1.0, 0.0, 0.0};
  TrackedBody body(config, 1.0);
  PoseMeasurement pose = poseAt(0.0);
  pose.orientation = Eigen::AngleAxisd(M_PI / 2.0, core::Vector3::UnitZ());
  EXPECT_EQ(body.add(&pose, nullptr), Rejection::NONE);
  pose.t = 1.0;
  pose.orientation.reset();
  EXPECT_EQ(body.add(&pose, nullptr), Rejection::NONE);
  EXPECT_NEAR(body.attachmentMotion(1.0).position.y(), 1.0, 1e-12);
}

}  // namespace tether_monitor::monitor
