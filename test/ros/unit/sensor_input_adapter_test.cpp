#include "tether_monitor/ros/sensor_input_adapter.h"

#include <gtest/gtest.h>

#include "support/estimator_fixture.h"
#include "tether_monitor/ros/geometry_conversions.h"
#include "tether_monitor/ros/input_adapter.h"

namespace tether_monitor
{
using core::Vector3;

bool says(const std::optional<InputError>& error, const std::string& words)
{
  return error && error->find(words) != std::string::npos;
}

// Off Trondheim; the world frame's x axis is 30 degrees north of east.
constexpr double LATITUDE = 63.45, LONGITUDE = 10.4, YAW = M_PI / 6.0, STILL_WATER = 40.0;

class SensorInputAdapterTest : public ::testing::Test
{
 protected:
  static monitor::Config located()
  {
    monitor::Config c = monitor::coarseConfig();
    c.inputs.datum = monitor::DatumConfig{LATITUDE, LONGITUDE, YAW, STILL_WATER};
    c.vessel.frame = "ship";
    return c;
  }
  explicit SensorInputAdapterTest(const monitor::Config& config = located())
    : estimator(config), adapter(estimator, transforms)
  {
    adapter.setTimeBase(TimeOrigin(ros::Time(100.0)));
  }
  void mount(const std::string& body, const std::string& sensor, const Vector3& place,
             const Eigen::Quaterniond& turn = Eigen::Quaterniond::Identity())
  {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = body;
    transform.child_frame_id = sensor;
    transform.transform.translation = vectorMessage(place);
    transform.transform.rotation = quaternionMessage(turn);
    transforms.setTransform(transform, "test", true);
  }
  static std_msgs::Header header(const std::string& frame, double t = 101.0)
  {
    std_msgs::Header h;
    h.stamp = ros::Time(t);
    h.frame_id = frame;
    return h;
  }
  // 1000 m along the world's x axis: 866 m east, 500 m north.
  static sensor_msgs::NavSatFix fix(const std::string& frame = "")
  {
    constexpr double NORTH = 111473.0, EAST = 111413.0 * 0.4469 * 1.00268;  // [m/deg] here, to a metre in 1000
    sensor_msgs::NavSatFix message;
    message.header = header(frame);
    message.latitude = LATITUDE + 500.0 / NORTH;
    message.longitude = LONGITUDE + 1000.0 * std::cos(YAW) / EAST;
    message.altitude = STILL_WATER + 3.0;
    return message;
  }
  static geometry_msgs::PoseStamped heading(double yaw, double t = 100.5)
  {
    geometry_msgs::PoseStamped pose;
    pose.header = header("map", t);
    pose.pose.orientation = quaternionMessage(Eigen::Quaterniond(Eigen::AngleAxisd(yaw, Vector3::UnitZ())));
    return pose;
  }
  const ros::Time now{101.0};
  tf2::BufferCore transforms;
  monitor::TetherEstimator estimator;
  InputAdapter adapter;
};

TEST_F(SensorInputAdapterTest, TakesAPlaceOnTheGlobeIntoTheWorldFrame)
{
  ASSERT_EQ(adapter.accept(Body::VESSEL, fix(), now), std::nullopt);
  const Vector3 place = estimator.vessel().track().at(1.0).position;
  EXPECT_NEAR(place.x(), 1000.0, 5.0);
  EXPECT_NEAR(place.y(), 0.0, 5.0);
  EXPECT_NEAR(place.z(), 3.0, 1e-9) << "over the still water, not over the ellipsoid";
}

TEST_F(SensorInputAdapterTest, TakesTheAntennaToTheReferencePoint)
{
  mount("ship", "antenna", {10.0, 0.0, 20.0});
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, fix("antenna"), now), "no attitude"));
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, fix("gps"), now), "frame 'gps' is not on the body"));
  sensor_msgs::Imu north;
  north.header = header("");
  north.orientation = quaternionMessage(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2 + YAW, Vector3::UnitZ())));
  ASSERT_EQ(adapter.accept(Body::VESSEL, north, now), std::nullopt);
  ASSERT_EQ(adapter.accept(Body::VESSEL, fix("antenna"), now), std::nullopt);
  const Vector3 place = estimator.vessel().track().at(1.0).position;
  EXPECT_NEAR(place.y(), -10.0, 5.0);
  EXPECT_NEAR(place.z(), 3.0 - 20.0, 1e-9);
}

TEST_F(SensorInputAdapterTest, RefusesAFixThatIsNone)
{
  sensor_msgs::NavSatFix lost = fix();
  lost.status.status = sensor_msgs::NavSatStatus::STATUS_NO_FIX;
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, lost, now), "no fix"));
  sensor_msgs::NavSatFix nowhere = fix();
  nowhere.latitude = NAN;
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, nowhere, now), "is no place"));
  monitor::TetherEstimator other(monitor::coarseConfig());
  InputAdapter without_datum(other, transforms);
  without_datum.setTimeBase(TimeOrigin(ros::Time(100.0)));
  EXPECT_TRUE(says(without_datum.accept(Body::VESSEL, fix(), now), "no datum"));
  EXPECT_FALSE(estimator.vessel().track().hasPose());
}

TEST_F(SensorInputAdapterTest, TheHeightOfAFloatingBodyMayBeConfigured)
{
  monitor::Config config = located();
  config.inputs.datum->altitude.reset();
  monitor::TetherEstimator unknown(config);
  InputAdapter without_height(unknown, transforms);
  without_height.setTimeBase(TimeOrigin(ros::Time(100.0)));
  EXPECT_TRUE(says(without_height.accept(Body::VESSEL, fix(), now), "not measured"));
  config.vessel.height = 1.5;
  monitor::TetherEstimator floating(config);
  InputAdapter with_height(floating, transforms);
  with_height.setTimeBase(TimeOrigin(ros::Time(100.0)));
  ASSERT_EQ(with_height.accept(Body::VESSEL, fix(), now), std::nullopt);
  EXPECT_NEAR(floating.vessel().track().at(1.0).position.z(), 1.5, 1e-9);
}

TEST_F(SensorInputAdapterTest, AnImuThatSitsTurnedGivesTheAttitudeOfTheBody)
{
  // Its x axis points to the left of the ship; the ship heads north.
  mount("ship", "imu", {0.0, 0.0, 5.0}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2, Vector3::UnitZ())));
  sensor_msgs::Imu imu;
  imu.header = header("imu");
  imu.orientation = quaternionMessage(Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Vector3::UnitZ())));
  imu.angular_velocity.z = 0.1;
  ASSERT_EQ(adapter.accept(Body::VESSEL, imu, now), std::nullopt);
  const monitor::MotionBuffer& track = estimator.vessel().track();
  ASSERT_TRUE(track.hasOrientation());
  const Vector3 ahead = track.orientationAt(1.0) * Vector3::UnitX();
  EXPECT_LT((ahead - Vector3(std::sin(YAW), std::cos(YAW), 0.0)).norm(), 1e-9) << "north in the world frame";
  const Vector3 later = track.orientationAt(1.2) * Vector3::UnitX();
  EXPECT_NEAR(ahead.cross(later).z(), std::sin(0.02), 1e-9) << "it goes on turning";
  imu.header.stamp += ros::Duration(0.1);
  imu.orientation_covariance[0] = -1.0;
  EXPECT_TRUE(says(adapter.accept(Body::VESSEL, imu, now), "no orientation"));
}

TEST_F(SensorInputAdapterTest, UnderNorthEastDownAnImuIsTurnedToo)
{
  monitor::Config config = monitor::coarseConfig();
  config.vehicle.body_axes = monitor::BodyAxes::FRD;
  monitor::TetherEstimator other(config);
  InputAdapter into(other, transforms);
  into.setTimeBase(TimeOrigin(ros::Time(100.0)));
  // Heads 30 degrees east of north, rolled by 10 degrees to starboard.
  const double heading = M_PI / 6.0, roll = M_PI / 18.0;
  sensor_msgs::Imu imu;
  imu.header = header("");
  imu.orientation = quaternionMessage(Eigen::Quaterniond(Eigen::AngleAxisd(heading, Vector3::UnitZ()) *
                                                         Eigen::AngleAxisd(roll, Vector3::UnitX())));
  imu.angular_velocity.z = 0.1;  // to starboard
  ASSERT_EQ(into.accept(Body::VEHICLE, imu, now), std::nullopt);
  const Eigen::Quaterniond attitude = other.vehicle().track().orientationAt(1.0);
  EXPECT_LT((attitude * Vector3::UnitX() - Vector3(std::sin(heading), std::cos(heading), 0.0)).norm(), 1e-9);
  EXPECT_NEAR((attitude * Vector3::UnitY()).z(), std::sin(roll), 1e-9) << "its port side is up";
}

TEST_F(SensorInputAdapterTest, APlainNumberMayHaveAnotherScale)
{
  monitor::SourceConfig height;
  height.scale = -1.0;
  std_msgs::Float64 up;
  up.data = -12.0;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, up, now, height), std::nullopt);
  geometry_msgs::PointStamped point;
  point.header = header("map");
  ASSERT_EQ(adapter.accept(Body::VEHICLE, point, now), std::nullopt);
  EXPECT_NEAR(estimator.vehicle().track().at(1.0).position.z(), -12.0, 1e-12);
}

TEST_F(SensorInputAdapterTest, ADepthCompletesAPlaceAndCountsMore)
{
  std_msgs::Float64 depth;
  depth.data = 50.0;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, depth, now), std::nullopt);
  EXPECT_FALSE(estimator.vehicle().track().hasPose());
  geometry_msgs::PointStamped point;
  point.header = header("map");
  point.point.x = 30.0;
  point.point.z = -47.0;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, point, now), std::nullopt);
  EXPECT_LT((estimator.vehicle().track().at(1.0).position - Vector3(30.0, 0.0, -50.0)).norm(), 1e-12);
}

TEST_F(SensorInputAdapterTest, PressureIsDepthBelowTheAir)
{
  sensor_msgs::FluidPressure pressure;
  pressure.header = header("");
  pressure.fluid_pressure = 101325.0 + 1025.0 * 9.81 * 20.0;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, pressure, now), std::nullopt);
  geometry_msgs::PointStamped point;
  point.header = header("map");
  ASSERT_EQ(adapter.accept(Body::VEHICLE, point, now), std::nullopt);
  EXPECT_NEAR(estimator.vehicle().track().at(1.0).position.z(), -20.0, 1e-9);
  pressure.header.stamp += ros::Duration(0.1);
  pressure.fluid_pressure = NAN;
  EXPECT_TRUE(says(adapter.accept(Body::VEHICLE, pressure, now), "not finite"));
}

TEST_F(SensorInputAdapterTest, ATransducerOnTheVesselNeedsNoOtherTransforms)
{
  // Looks down: its x axis ahead, its z axis down. The ship heads along y at (0, 0, 0).
  mount("ship", "transducer", {2.0, 0.0, -4.0}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI, Vector3::UnitX())));
  AcousticFix fix;
  fix.header = header("transducer");
  fix.range = 100.0;
  fix.bearing = -0.5;  // to its right about z down: to the left of the ship
  fix.elevation = 0.6;
  EXPECT_TRUE(says(adapter.accept(Body::VEHICLE, fix, now), "transducer")) << "where is the ship?";
  ASSERT_EQ(adapter.accept(Body::VESSEL, heading(M_PI_2), now), std::nullopt);
  ASSERT_EQ(adapter.accept(Body::VEHICLE, fix, now), std::nullopt);
  const double ahead = 2.0 + 100.0 * std::cos(0.6) * std::cos(0.5), left = 100.0 * std::cos(0.6) * std::sin(0.5);
  EXPECT_LT(
      (estimator.vehicle().track().at(1.0).position - Vector3(-left, ahead, -4.0 - 100.0 * std::sin(0.6))).norm(),
      1e-9);
  fix.range = -1.0;
  EXPECT_TRUE(says(adapter.accept(Body::VEHICLE, fix, now), "range"));
}

TEST_F(SensorInputAdapterTest, AVelocityLogIsTurnedAndItsLeverTakenOff)
{
  mount("base_link", "log", {1.0, 0.0, 0.0}, Eigen::Quaterniond(Eigen::AngleAxisd(M_PI_2, Vector3::UnitZ())));
  geometry_msgs::PoseStamped pose = heading(0.0, 100.0);
  for (double t = 100.0; t < 101.01; t += 0.1)
  {
    pose = heading(0.2 * (t - 100.0), t);
    ASSERT_EQ(adapter.accept(Body::VEHICLE, pose, now), std::nullopt);
  }
  // The body goes 1 m/s ahead and turns at 0.2 rad/s: its log sees 1 m/s ahead and 0.2 m/s to the left.
  geometry_msgs::TwistWithCovarianceStamped twist;
  twist.header = header("log");
  twist.twist.twist.linear.x = 0.2;
  twist.twist.twist.linear.y = -1.0;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, twist, now), std::nullopt);
  const monitor::BodyState at = estimator.vehicle().track().at(1.0);
  EXPECT_LT((at.velocity - Vector3(std::cos(0.2), std::sin(0.2), 0.0)).norm(), 1e-3) << at.velocity.transpose();
}

TEST_F(SensorInputAdapterTest, ASourceHasItsOwnLatencyFrameAndAccuracy)
{
  monitor::SourceConfig late;
  late.latency = 0.5;
  late.frame = "beacon";
  mount("base_link", "beacon", {0.0, 0.0, 1.0});
  geometry_msgs::PoseStamped before = heading(0.0, 100.2);
  before.pose.position.z = -31.0;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, before, now), std::nullopt);
  geometry_msgs::PointStamped point;
  point.header = header("map");
  point.point.z = -30.0;
  ASSERT_EQ(adapter.accept(Body::VEHICLE, point, now, late), std::nullopt);
  EXPECT_NEAR(estimator.vehicle().track().lastPoseTime(), 0.5, 1e-9);
  EXPECT_NEAR(estimator.vehicle().track().at(0.5).position.z(), -31.0, 1e-9);
}

TEST_F(SensorInputAdapterTest, AJointOfAWinchTellsTheLength)
{
  sensor_msgs::JointState joints;
  joints.header = header("");
  joints.name = {"thruster", "drum"};
  joints.position = {3.0, 100.0};
  joints.velocity = {0.0, 2.0};
  EXPECT_TRUE(says(adapter.accept(joints, now), "payout_joint"));
  monitor::Config config = monitor::coarseConfig();
  config.inputs.winch_joint = monitor::WinchJointConfig{"drum", 0.25, 40.0};
  monitor::TetherEstimator other(config);
  InputAdapter taking(other, transforms);
  taking.setTimeBase(TimeOrigin(ros::Time(100.0)));
  ASSERT_EQ(taking.accept(joints, now), std::nullopt);
  joints.name = {"thruster", "propeller"};
  EXPECT_EQ(taking.accept(joints, now), std::nullopt) << "another's joints are no matter";
  joints.name = {"thruster", "drum"};
  joints.position = {3.0};
  joints.header.stamp += ros::Duration(0.1);
  EXPECT_TRUE(says(taking.accept(joints, now), "has no position"));
  std_msgs::Float64 length;
  length.data = 65.2;
  EXPECT_EQ(taking.acceptLength(length, now + ros::Duration(0.2)), std::nullopt);
}

}  // namespace tether_monitor
