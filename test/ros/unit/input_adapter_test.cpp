#include "tether_monitor/ros/input_adapter.h"

#include <gtest/gtest.h>

#include "support/estimator_fixture.h"
#include "tether_monitor/monitor/estimator/filtered_vessel_end.h"
#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
bool says(const std::optional<InputError>& error, const std::string& words)
{
  return error && error->find(words) != std::string::npos;
}

class InputAdapterTest : public ::testing::Test
{
 protected:
  InputAdapterTest() : estimator(monitor::coarseConfig()), adapter(estimator, transforms)
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

TEST_F(InputAdapterTest, TransformsAKnownFrame)
{
  ASSERT_EQ(adapter.accept(Body::VESSEL, pose("site"), now), std::nullopt);
  EXPECT_LT((estimator.vessel().track().at(1.0).position - core::Vector3(10.0, 1.0, 0.0)).norm(), 1e-12);
}

TEST_F(InputAdapterTest, RefusesAnUnknownAnEmptyFrameAndTheFuture)
{
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, pose("nowhere"), now), "nowhere"));
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, pose(""), now), "empty"));
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, pose("map"), ros::Time(50.0)), "future"));
  EXPECT_FALSE(estimator.vessel().track().hasPose());
}

TEST_F(InputAdapterTest, TurnsATwistInBodyAxesIntoTheWorld)
{
  geometry_msgs::PoseStamped p = pose("map");
  p.pose.orientation.z = p.pose.orientation.w = std::sqrt(0.5);
  geometry_msgs::TwistStamped twist;
  twist.header = p.header;
  twist.header.frame_id = "base_link";
  twist.twist.linear.x = 2.0;  // ahead
  EXPECT_TRUE(adapter.accept(Body::VEHICLE, twist, now)) << "no attitude yet";
  ASSERT_EQ(adapter.accept(Body::VEHICLE, p, now), std::nullopt);
  ASSERT_EQ(adapter.accept(Body::VEHICLE, twist, now), std::nullopt);
  EXPECT_LT((estimator.vehicle().track().at(1.0).velocity - core::Vector3(0.0, 2.0, 0.0)).norm(), 1e-12);
}

TEST_F(InputAdapterTest, OdometryCarriesBothInItsOwnFrames)
{
  nav_msgs::Odometry odom;
  odom.header = pose("map").header;
  odom.pose.pose.orientation.z = odom.pose.pose.orientation.w = std::sqrt(0.5);
  odom.twist.twist.linear.x = 1.0;
  odom.twist.twist.angular.z = 0.3;
  ASSERT_EQ(adapter.accept(Body::VESSEL, odom, now), std::nullopt);
  EXPECT_LT((estimator.vessel().track().at(1.0).velocity - core::Vector3(0.0, 1.0, 0.0)).norm(), 1e-12);
  EXPECT_NEAR(estimator.vessel().track().at(1.0).angular_velocity.z(), 0.3, 1e-12);
  odom.twist.twist.linear.x = NAN;
  odom.header.stamp += ros::Duration(0.1);
  EXPECT_TRUE(adapter.accept(Body::VESSEL, odom, now));
  EXPECT_NEAR(estimator.vessel().track().age(1.1), 0.1, 1e-12) << "a refused odometry leaves no pose behind";
}

TEST_F(InputAdapterTest, OdometryKeepsItsCovariance)
{
  monitor::Config observed = monitor::coarseConfig();
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
  ASSERT_EQ(into.accept(Body::VESSEL, odom, now), std::nullopt) << "a height alone";
  const monitor::VesselMotionFilter& filter =
      dynamic_cast<const monitor::FilteredVesselEnd&>(other.vessel()).filter();
  EXPECT_FALSE(filter.hasPosition());
  EXPECT_TRUE(filter.axis(2).isStarted());
  EXPECT_FALSE(filter.axis(0).isStarted());
  for (int i = 0; i < 6; ++i)
    odom.pose.covariance[7 * i] = i == 0 ? 0.04 : 0.0025;
  odom.header.stamp += ros::Duration(0.1);
  ASSERT_EQ(into.accept(Body::VESSEL, odom, now), std::nullopt);
  const core::Vector3 stddev = filter.at(1.1).position_stddev;
  EXPECT_NEAR(stddev.y() * stddev.y() - stddev.x() * stddev.x(), 0.04 - 0.0025, 1e-6)
      << "the frame is turned by a quarter: its x is our y";
  for (int i = 0; i < 6; ++i)
    odom.pose.covariance[7 * i] = 1e6;
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, odom, now), "not measured")) << "mode tracked";
}

TEST_F(InputAdapterTest, TwistAndBodyAxesAreAsConfigured)
{
  // Heading west, 2 m/s ahead: the same motion as four kinds of stacks say it.
  const Eigen::Quaterniond flu(Eigen::AngleAxisd(M_PI, core::Vector3::UnitZ()));
  const Eigen::Quaterniond frd = flu * Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0);
  const core::Vector3 velocity(-2.0, 0.0, 0.5);
  for (const auto axes : {monitor::BodyAxes::FLU, monitor::BodyAxes::FRD})
    for (const auto frame : {monitor::TwistFrame::CHILD, monitor::TwistFrame::WORLD})
    {
      monitor::Config config = monitor::coarseConfig();
      config.vehicle.body_axes = axes;
      config.vehicle.twist_frame = frame;
      monitor::TetherEstimator other(config);
      InputAdapter into(other, transforms);
      into.setTimeBase(TimeOrigin(ros::Time(100.0)));
      const Eigen::Quaterniond q = axes == monitor::BodyAxes::FLU ? flu : frd;
      nav_msgs::Odometry odom;
      odom.header = pose("map").header;
      odom.pose.pose.orientation = quaternionMessage(q);
      odom.twist.twist.linear =
          vectorMessage(frame == monitor::TwistFrame::WORLD ? velocity : core::Vector3(q.conjugate() * velocity));
      ASSERT_EQ(into.accept(Body::VEHICLE, odom, now), std::nullopt);
      EXPECT_LT((other.vehicle().track().at(1.0).velocity - velocity).norm(), 1e-12);
      EXPECT_LT(other.vehicle().track().at(1.0).orientation.angularDistance(flu), 1e-12);
      geometry_msgs::TwistStamped twist;
      twist.header = odom.header;
      twist.header.stamp += ros::Duration(0.1);
      twist.header.frame_id = "base_link";
      twist.twist.linear = odom.twist.twist.linear;
      ASSERT_EQ(into.accept(Body::VEHICLE, twist, now), std::nullopt);
      EXPECT_LT((other.vehicle().track().at(1.1).velocity - velocity).norm(), 1e-12);
    }
}

TEST_F(InputAdapterTest, FieldsThatNobodyFillsAreNotMeasured)
{
  nav_msgs::Odometry odom;
  odom.header = pose("map").header;
  odom.pose.pose.position.x = 3.0;  // a quaternion of zeros, a twist of zeros without covariance
  ASSERT_EQ(adapter.accept(Body::VEHICLE, odom, now), std::nullopt);
  EXPECT_TRUE(estimator.vehicle().track().hasPose());
  EXPECT_FALSE(estimator.vehicle().track().hasRates(1.0));
  odom.header.stamp += ros::Duration(0.1);
  odom.twist.covariance[0] = odom.twist.covariance[7] = odom.twist.covariance[14] = 0.01;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, odom, now), std::nullopt);
  EXPECT_TRUE(estimator.vehicle().track().hasRates(1.1)) << "a velocity of zero that somebody vouches for";
  odom.header.stamp += ros::Duration(0.1);
  odom.twist.twist.linear.x = 1.0;
  odom.pose.covariance[0] = odom.twist.covariance[0] = NAN;
  EXPECT_EQ(adapter.accept(Body::VEHICLE, odom, now), std::nullopt) << "a covariance of NaN is none";
}

TEST_F(InputAdapterTest, ChecksPayoutAndCurrent)
{
  Payout payout;
  payout.header.stamp = now;
  payout.length = -1.0;
  EXPECT_TRUE(adapter.accept(payout, now));
  payout.length = 80.0;
  EXPECT_EQ(adapter.accept(payout, now), std::nullopt);
  EXPECT_TRUE(adapter.accept(payout, now)) << "not later than the last";
  CurrentProfile current;
  current.header = pose("map").header;
  current.depth = {0.0, 10.0};
  current.velocity.resize(1);
  EXPECT_TRUE(adapter.accept(current, now));
  current.velocity.resize(2);
  current.velocity[1].x = 0.5;
  EXPECT_EQ(adapter.accept(current, now), std::nullopt);
  EXPECT_DOUBLE_EQ(estimator.simulation().model.environment().current().at(-10.0).x(), 0.5);
}

TEST_F(InputAdapterTest, ObstaclesAreCheckedAndTakenToTheWorld)
{
  ObstacleArray array;
  array.header = pose("map").header;
  array.obstacles.resize(1);
  Obstacle& pile = array.obstacles[0];
  pile.name = "pile";
  pile.shape = Obstacle::CYLINDER;
  pile.pose.position.x = 10.0;
  pile.size = {0.5};
  EXPECT_TRUE(says(adapter.accept(array, now), "size has 1"));
  pile.size = {0.5, 20.0};
  EXPECT_EQ(adapter.accept(array, now), std::nullopt);
  ASSERT_EQ(estimator.simulation().model.environment().obstacles().size(), 1u);
  EXPECT_EQ(estimator.simulation().model.environment().obstacles()[0].size.y(), 20.0);
  EXPECT_EQ(estimator.simulation().model.environment().obstacles()[0].orientation.w(), 1.0)
      << "an orientation of zeros is none";
  pile.shape = 7;
  EXPECT_TRUE(says(adapter.accept(array, now), "shape = 7"));
  pile.shape = Obstacle::CYLINDER;
  pile.friction = NAN;
  EXPECT_TRUE(says(adapter.accept(array, now), "friction"));
  EXPECT_EQ(estimator.simulation().model.environment().obstacles()[0].friction, 0.0)
      << "a refused message changes nothing";
}

TEST_F(InputAdapterTest, ThrustDepthAndTurnsNeedWhatTheyActOn)
{
  geometry_msgs::WrenchStamped thrust;
  thrust.header.stamp = now;
  thrust.header.frame_id = "base_link";
  EXPECT_TRUE(says(adapter.accept(thrust, now), "not simulated"));
  std_msgs::Float64 number;
  number.data = 50.0;
  EXPECT_TRUE(says(adapter.acceptDepth(number, now), "environment.seabed"));
  EXPECT_TRUE(says(adapter.acceptTurns(number, now), "winch"));

  monitor::Config rich = monitor::coarseConfig();
  rich.environment.seabed = core::Seabed();
  rich.winch = core::WinchProperties{0.5, 0.6, 4};
  monitor::TetherEstimator other(rich);
  InputAdapter taking(other, transforms);
  taking.setTimeBase(TimeOrigin(ros::Time(100.0)));
  EXPECT_EQ(taking.acceptDepth(number, now), std::nullopt);
  EXPECT_EQ(other.simulation().model.environment().seabed()->depth, 50.0);
  EXPECT_EQ(taking.acceptTurns(number, now), std::nullopt);
  number.data = 1e6;
  EXPECT_TRUE(says(taking.acceptTurns(number, now), "turns = "));
}

}  // namespace tether_monitor
