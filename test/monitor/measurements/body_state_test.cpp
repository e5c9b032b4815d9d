#include "tether_monitor/monitor/measurements/body_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/matrix_compare.h"

namespace tether_monitor::monitor
{
namespace
{
const Eigen::Quaterniond QUARTER(Eigen::AngleAxisd(M_PI / 2.0, core::Vector3::UnitZ()));
}

TEST(BodyState, APointOnALeverMovesWithPositionAndTurn)
{
  BodyState body;
  body.position = {1.0, 2.0, 3.0};
  body.orientation = QUARTER;
  body.velocity = {1.0, 0.0, 0.5};
  body.angular_velocity = {0.0, 0.0, 2.0};
  const core::EndMotion point = body.attachmentPoint({1.0, 0.0, -1.0});
  EXPECT_TRUE(matricesNear(point.position, core::Vector3(1.0, 3.0, 2.0), 1e-14));
  EXPECT_TRUE(matricesNear(point.velocity, core::Vector3(-1.0, 0.0, 0.5), 1e-14));
  EXPECT_EQ(body.attachmentPoint(core::Vector3::Zero()).position, body.position);
}

TEST(BodyState, OfANodeIsTheReferencePointBehindTheLever)
{
  core::NodeField shape(2, core::NodeCoords::Zero());
  shape[1] << 10.0, 0.0, -5.0, 1.0, 0.0, 0.0;
  const core::CableState state(0.0, shape, core::Vector3(0.2, 0.0, 0.0));
  core::AttitudeState attitude;
  attitude.orientation = QUARTER;
  attitude.velocity = {3.0, 0.0, 0.0};  // body axes: about y of the world
  const core::Vector3 lever(2.0, 0.0, 1.0);
  const BodyState body = BodyState::ofNode(state, 1, attitude, lever);
  EXPECT_TRUE(matricesNear(body.position, core::Vector3(10.0, -2.0, -6.0), 1e-14));
  EXPECT_TRUE(matricesNear(body.angular_velocity, core::Vector3(0.0, 3.0, 0.0), 1e-14));
  // The lever is (0, 2, 1) in the world: v - w x lever = (0.2, 0, 0) - (3, 0, 0).
  EXPECT_TRUE(matricesNear(body.velocity, core::Vector3(-2.8, 0.0, 0.0), 1e-14));
  const core::EndMotion node = body.attachmentPoint(lever);
  EXPECT_TRUE(matricesNear(node.position, core::Vector3(10.0, 0.0, -5.0), 1e-14));
  EXPECT_TRUE(matricesNear(node.velocity, core::Vector3(0.2, 0.0, 0.0), 1e-14));
}
}  // namespace tether_monitor::monitor
