#include "tether_monitor/ros/message_conversions.h"

#include <gtest/gtest.h>

#include "support/estimator_fixture.h"
#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
TEST(StateMessage, OfAnInvalidEstimateIsEmptyAndNaN)
{
  monitor::TetherEstimate e;
  e.stations = core::StationProfile(10);
  TetherState message;
  message.s = {1.0, 2.0};
  message.max_tension = 7.0;
  toMessage(e, message);
  EXPECT_TRUE(message.s.empty());
  EXPECT_TRUE(message.stress.empty());
  EXPECT_TRUE(std::isnan(message.max_tension));
  EXPECT_TRUE(std::isnan(message.vehicle_relative.x));
  EXPECT_TRUE(std::isinf(message.vessel_age));
  EXPECT_TRUE(std::isnan(
      wrenchMessage(std_msgs::Header(), e, core::Vector3::Ones(), core::Vector3::Zero()).wrench.force.x));
}

TEST(StateMessage, CarriesTheEstimate)
{
  monitor::TetherEstimator estimator(monitor::coarseConfig());
  const monitor::TetherEstimate& e =
      estimator.begin(0.0, {{{0, 0, 0}, {0, 0, 0}}, {{50, 0, -60}, {0, 0, 0}}, 0.1, 0.2});
  ASSERT_TRUE(e.has_stations);
  TetherState message;
  toMessage(e, message);
  ASSERT_EQ(message.s.size(), 21u);
  EXPECT_EQ(message.position.size(), 21u);
  const double stress = message.tension[4] / monitor::coarseConfig().tether.displacedArea();
  EXPECT_NEAR(message.stress[4], stress, 1e-12 * stress);
  EXPECT_NEAR(message.vehicle_relative.z, -60.0, 1e-9);
  EXPECT_EQ(message.vehicle_age, 0.2);
}

TEST(VehicleMessage, CarriesTheWholeCovarianceInItsAxes)
{
  monitor::TetherEstimate e;
  e.has_vehicle = true;
  e.vehicle.orientation = Eigen::AngleAxisd(M_PI / 2.0, core::Vector3::UnitZ());
  e.vehicle_position_stddev = 1.0;
  e.vehicle_position_covariance << 4.0, 1.0, 0.5, 1.0, 2.0, 0.3, 0.5, 0.3, 3.0;
  e.vehicle_velocity_covariance = core::Vector3(0.01, 0.04, 0.09).asDiagonal();
  const nav_msgs::Odometry message = vehicleMessage(std_msgs::Header(), monitor::BodyConfig(), e);
  EXPECT_EQ(block(message.pose.covariance, 0), e.vehicle_position_covariance) << "axes of the world";
  EXPECT_NEAR(message.twist.covariance[0], 0.04, 1e-12) << "axes of the body";
  EXPECT_NEAR(message.twist.covariance[7], 0.01, 1e-12);
  EXPECT_GE(message.pose.covariance[35], NOT_MEASURED_ANGLE * NOT_MEASURED_ANGLE)
      << "nothing estimates the attitude";
}

TEST(MessageConversions, TheWrenchOnTheVehicleIsInItsOwnAxesAboutItsReferencePoint)
{
  monitor::TetherEstimate e;
  e.has_stations = true;
  e.stations.ends.vehicle = {0.0, 100.0, 50.0};
  e.vehicle_tension_stddev = 10.0;
  monitor::BodyConfig body;
  body.attachment = {0.0, 0.0, 0.5};
  const Eigen::Quaterniond to_the_left(Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ()));  // its x is world y
  WrenchWithCovarianceStamped message = bodyWrenchMessage(std_msgs::Header(), e, to_the_left, body);
  EXPECT_NEAR(message.wrench.force.x, 100.0, 1e-9);
  EXPECT_NEAR(message.wrench.force.y, 0.0, 1e-9);
  EXPECT_NEAR(message.wrench.force.z, 50.0, 1e-9);
  EXPECT_NEAR(message.wrench.torque.x, 0.0, 1e-9);
  EXPECT_NEAR(message.wrench.torque.y, 50.0, 1e-9) << "0.5 m above, drawn forward: it pitches down";
  EXPECT_NEAR(message.covariance[0], 100.0, 1e-9);
  EXPECT_NEAR(message.covariance[6 * 4 + 4], 25.0, 1e-9);
  EXPECT_NEAR(message.covariance[6 * 0 + 4], 50.0, 1e-9);
  EXPECT_NEAR(message.covariance[6 * 5 + 5], 0.0, 1e-9);

  body.body_axes = monitor::BodyAxes::FRD;
  message = bodyWrenchMessage(std_msgs::Header(), e, to_the_left, body);
  EXPECT_NEAR(message.wrench.force.z, -50.0, 1e-9);
  EXPECT_NEAR(message.wrench.torque.y, -50.0, 1e-9);
  EXPECT_TRUE(std::isnan(bodyWrenchMessage(std_msgs::Header(), e, std::nullopt, body).wrench.force.x));
}

}  // namespace tether_monitor
