#include "tether_monitor/ros/message_conversions.h"

#include <gtest/gtest.h>

#include "support/estimator_fixture.h"
#include "tether_monitor/ros/input_adapter.h"
#include "tether_monitor/ros/markers.h"

namespace tether_monitor
{
monitor::Config config()
{
  monitor::Config c = monitor::testConfig();
  c.elements = 10;
  return c;
}

TEST(TimeOrigin, GoesBothWaysToTheNanosecond)
{
  const TimeOrigin base(ros::Time(1700000000, 123456789));
  EXPECT_NEAR(base.seconds(ros::Time(1700000001, 5)), 1.000000005, 1e-12);
  EXPECT_EQ(base.stamp(base.seconds(ros::Time(1700000123, 456789012))), ros::Time(1700000123, 456789012));
  EXPECT_EQ(TimeOrigin().stamp(-5.0), ros::Time());
}

TEST(Quaternion, KeepsItsOrder)
{
  geometry_msgs::Quaternion q;
  q.x = 0.1, q.y = 0.2, q.z = 0.3, q.w = 0.9;
  EXPECT_EQ(quaternion(q).x(), 0.1);
  EXPECT_EQ(quaternion(q).w(), 0.9);
}

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
  EXPECT_TRUE(std::isnan(wrenchMessage(std_msgs::Header(), e, core::Vector3::Ones()).wrench.force.x));
}

TEST(StateMessage, CarriesTheEstimate)
{
  monitor::TetherEstimator estimator(config());
  const monitor::TetherEstimate& e =
      estimator.begin(0.0, {{{0, 0, 0}, {0, 0, 0}}, {{50, 0, -60}, {0, 0, 0}}, 0.1, 0.2});
  ASSERT_TRUE(e.has_stations);
  TetherState message;
  toMessage(e, message);
  ASSERT_EQ(message.s.size(), 21u);
  EXPECT_EQ(message.position.size(), 21u);
  EXPECT_EQ(message.stress[4], message.tension[4] / config().tether.displacedArea());
  EXPECT_NEAR(message.vehicle_relative.z, -60.0, 1e-9);
  EXPECT_EQ(message.vehicle_age, 0.2);
}

TEST(Markers, KeepTheirIdsAndAreDeletedWhileInvalid)
{
  monitor::TetherEstimator estimator(config());
  const auto names = [](const visualization_msgs::MarkerArray& array)
  {
    std::vector<std::pair<std::string, int>> ids;
    for (const auto& m : array.markers)
      ids.emplace_back(m.ns, m.id);
    return ids;
  };
  const auto invalid = markers(std_msgs::Header(), estimator);
  EXPECT_EQ(invalid.markers[0].action, visualization_msgs::Marker::DELETE);
  estimator.begin(0.0, {{{0, 0, 0}, {0, 0, 0}}, {{50, 0, -60}, {0, 0, 0}}, 0.0, 0.0});
  const auto valid = markers(std_msgs::Header(), estimator);
  EXPECT_EQ(names(invalid), names(valid));
  EXPECT_EQ(valid.markers[0].action, visualization_msgs::Marker::ADD);
  EXPECT_EQ(valid.markers[0].points.size(), valid.markers[0].colors.size());
}

TEST(UtilisationColour, GoesFromGreenOverYellowToRed)
{
  EXPECT_GT(utilisationColour(0.0, 0.8).g, 0.7);
  EXPECT_LT(utilisationColour(0.0, 0.8).r, 0.3);
  EXPECT_GT(utilisationColour(0.8, 0.8).r, 0.9);
  EXPECT_GT(utilisationColour(0.8, 0.8).g, 0.8);
  EXPECT_LT(utilisationColour(1.2, 0.8).g, 0.1);
}

class Intake : public ::testing::Test
{
 protected:
  Intake() : estimator(config()), adapter(estimator, transforms)
  {
    adapter.setTimeBase(TimeOrigin(ros::Time(100.0)));
    geometry_msgs::TransformStamped shift;
    shift.header.frame_id = "map";
    shift.child_frame_id = "site";
    shift.transform.translation.x = 10.0;
    shift.transform.rotation.z = shift.transform.rotation.w = std::sqrt(0.5);  // a quarter turn to the left
    transforms.setTransform(shift, "test", true);
  }
  geometry_msgs::PoseStamped pose(const std::string& frame) const
  {
    geometry_msgs::PoseStamped p;
    p.header.stamp = ros::Time(101.0);
    p.header.frame_id = frame;
    p.pose.position.x = 1.0;
    p.pose.orientation.w = 1.0;
    return p;
  }
  const ros::Time now{101.0};
  monitor::TetherEstimator estimator;
  tf2::BufferCore transforms;
  InputAdapter adapter;
};

TEST_F(Intake, TransformsAKnownFrame)
{
  ASSERT_EQ(adapter.accept(Body::VESSEL, pose("site"), now), "");
  EXPECT_LT((estimator.vesselTrack().at(1.0).position - core::Vector3(10.0, 1.0, 0.0)).norm(), 1e-12);
}

TEST_F(Intake, RefusesAnUnknownAnEmptyFrameAndTheFuture)
{
  EXPECT_NE(adapter.accept(Body::VESSEL, pose("nowhere"), now).find("nowhere"), std::string::npos);
  EXPECT_NE(adapter.accept(Body::VESSEL, pose(""), now).find("empty"), std::string::npos);
  EXPECT_NE(adapter.accept(Body::VESSEL, pose("map"), ros::Time(50.0)).find("future"), std::string::npos);
  EXPECT_FALSE(estimator.vesselTrack().hasPose());
}

TEST_F(Intake, TurnsATwistInBodyAxesIntoTheWorld)
{
  geometry_msgs::PoseStamped p = pose("map");
  p.pose.orientation.z = p.pose.orientation.w = std::sqrt(0.5);
  geometry_msgs::TwistStamped twist;
  twist.header = p.header;
  twist.header.frame_id = "base_link";
  twist.twist.linear.x = 2.0;  // ahead
  EXPECT_NE(adapter.accept(Body::VEHICLE, twist, now), "") << "no attitude yet";
  ASSERT_EQ(adapter.accept(Body::VEHICLE, p, now), "");
  ASSERT_EQ(adapter.accept(Body::VEHICLE, twist, now), "");
  EXPECT_LT((estimator.vehicleTrack().at(1.0).velocity - core::Vector3(0.0, 2.0, 0.0)).norm(), 1e-12);
}

TEST_F(Intake, OdometryCarriesBothInItsOwnFrames)
{
  nav_msgs::Odometry odom;
  odom.header = pose("map").header;
  odom.pose.pose.orientation.z = odom.pose.pose.orientation.w = std::sqrt(0.5);
  odom.twist.twist.linear.x = 1.0;
  odom.twist.twist.angular.z = 0.3;
  ASSERT_EQ(adapter.accept(Body::VESSEL, odom, now), "");
  EXPECT_LT((estimator.vesselTrack().at(1.0).velocity - core::Vector3(0.0, 1.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(estimator.vesselTrack().at(1.0).angular_velocity.z(), 0.3, 1e-12);
  odom.twist.twist.linear.x = NAN;
  odom.header.stamp += ros::Duration(0.1);
  EXPECT_NE(adapter.accept(Body::VESSEL, odom, now), "");
  EXPECT_NEAR(estimator.vesselTrack().age(1.1), 0.1, 1e-12) << "a refused odometry leaves no pose behind";
}

TEST_F(Intake, OdometryKeepsItsCovariance)
{
  monitor::Config observed = config();
  observed.vehicle_mode = monitor::VehicleMode::OBSERVED;
  observed.vehicle_body.mass = observed.vehicle_body.volume = 1.0;
  observed.vehicle_body.inertia.setOnes();
  monitor::TetherEstimator other(observed);
  InputAdapter into(other, transforms);
  into.setTimeBase(TimeOrigin(ros::Time(100.0)));
  nav_msgs::Odometry odom;
  odom.header = pose("site").header;
  odom.pose.pose.orientation.w = 1.0;
  odom.pose.pose.position.z = 2.0;
  for (int i = 0; i < 6; ++i)
    odom.pose.covariance[7 * i] = odom.twist.covariance[7 * i] = i == 2 ? 0.0025 : 1e6;
  ASSERT_EQ(into.accept(Body::VESSEL, odom, now), "") << "a height alone";
  EXPECT_FALSE(other.vesselFilter().hasPosition());
  EXPECT_TRUE(other.vesselFilter().axis(2).isStarted());
  EXPECT_FALSE(other.vesselFilter().axis(0).isStarted());
  for (int i = 0; i < 6; ++i)
    odom.pose.covariance[7 * i] = i == 0 ? 0.04 : 0.0025;
  odom.header.stamp += ros::Duration(0.1);
  ASSERT_EQ(into.accept(Body::VESSEL, odom, now), "");
  const core::Vector3 stddev = other.vesselFilter().at(1.1).position_stddev;
  EXPECT_NEAR(stddev.y() * stddev.y() - stddev.x() * stddev.x(), 0.04 - 0.0025, 1e-6)
      << "the frame is turned by a quarter: its x is our y";
  for (int i = 0; i < 6; ++i)
    odom.pose.covariance[7 * i] = 1e6;
  EXPECT_NE(adapter.accept(Body::VESSEL, odom, now).find("not measured"), std::string::npos) << "mode tracked";
}

TEST_F(Intake, ChecksPayoutAndCurrent)
{
  Payout payout;
  payout.header.stamp = now;
  payout.length = -1.0;
  EXPECT_NE(adapter.accept(payout, now), "");
  payout.length = 80.0;
  EXPECT_EQ(adapter.accept(payout, now), "");
  EXPECT_NE(adapter.accept(payout, now), "") << "not later than the last";
  CurrentProfile current;
  current.header = pose("map").header;
  current.depth = {0.0, 10.0};
  current.velocity.resize(1);
  EXPECT_NE(adapter.accept(current, now), "");
  current.velocity.resize(2);
  current.velocity[1].x = 0.5;
  EXPECT_EQ(adapter.accept(current, now), "");
  EXPECT_DOUBLE_EQ(estimator.model().environment().current.at(-10.0).x(), 0.5);
}

TEST_F(Intake, ObstaclesAreCheckedAndTakenToTheWorld)
{
  ObstacleArray array;
  array.header = pose("map").header;
  array.obstacles.resize(1);
  Obstacle& pile = array.obstacles[0];
  pile.name = "pile";
  pile.shape = Obstacle::CYLINDER;
  pile.pose.position.x = 10.0;
  pile.size = {0.5};
  EXPECT_NE(adapter.accept(array, now).find("size has 1"), std::string::npos);
  pile.size = {0.5, 20.0};
  EXPECT_EQ(adapter.accept(array, now), "");
  ASSERT_EQ(estimator.model().environment().obstacles.size(), 1u);
  EXPECT_EQ(estimator.model().environment().obstacles[0].size.y(), 20.0);
  EXPECT_EQ(estimator.model().environment().obstacles[0].orientation.w(), 1.0)
      << "an orientation of zeros is none";
  pile.shape = 7;
  EXPECT_NE(adapter.accept(array, now).find("shape = 7"), std::string::npos);
  pile.shape = Obstacle::CYLINDER;
  pile.friction = NAN;
  EXPECT_NE(adapter.accept(array, now).find("friction"), std::string::npos);
  EXPECT_EQ(estimator.model().environment().obstacles[0].friction, 0.0) << "a refused message changes nothing";
}

TEST_F(Intake, ThrustDepthAndTurnsNeedWhatTheyActOn)
{
  geometry_msgs::WrenchStamped thrust;
  thrust.header.stamp = now;
  thrust.header.frame_id = "base_link";
  EXPECT_NE(adapter.accept(thrust, now).find("not simulated"), std::string::npos);
  std_msgs::Float64 number;
  number.data = 50.0;
  EXPECT_NE(adapter.acceptDepth(number, now).find("environment.seabed"), std::string::npos);
  EXPECT_NE(adapter.acceptTurns(number, now).find("winch"), std::string::npos);

  monitor::Config rich = config();
  rich.environment.seabed = core::Seabed();
  rich.winch = core::WinchProperties{0.5, 0.6, 4};
  monitor::TetherEstimator other(rich);
  InputAdapter taking(other, transforms);
  taking.setTimeBase(TimeOrigin(ros::Time(100.0)));
  EXPECT_EQ(taking.acceptDepth(number, now), "");
  EXPECT_EQ(other.model().environment().seabed->depth, 50.0);
  EXPECT_EQ(taking.acceptTurns(number, now), "");
  number.data = 1e6;
  EXPECT_NE(taking.acceptTurns(number, now).find("turns = "), std::string::npos);
}

}  // namespace tether_monitor
