#include "tether_monitor/ros/motion_input_adapter.h"

#include <cmath>

#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
namespace
{
using Result = std::optional<InputError>;

Result outOfBounds(const monitor::TwistMeasurement& rates)
{
  const Result error = tether_monitor::outOfBounds(Field::VELOCITY, rates.velocity);
  return error ? error : tether_monitor::outOfBounds(Field::ANGULAR_VELOCITY, rates.angular_velocity);
}

// Of a body in a message, turned to the world and to the axes of the package; none if it says nothing (all zero).
std::optional<Eigen::Quaterniond> orientationOf(const geometry_msgs::Quaternion& message,
                                                const Eigen::Isometry3d& to_world, const monitor::BodyConfig& body)
{
  const Eigen::Quaterniond q = quaternion(message);
  if (q.coeffs().isZero(0.0))
    return std::nullopt;
  const Eigen::Quaterniond turned = Eigen::Quaterniond(to_world.rotation()) * q;
  return body.body_axes == monitor::BodyAxes::FRD ? turned * monitor::halfTurnAboutX() : turned;
}

// From the axes in which a body's messages are to the world.
core::Matrix3 messageAxesToWorld(const monitor::BodyConfig& body, const Eigen::Quaterniond& orientation)
{
  const bool is_turned = body.body_axes == monitor::BodyAxes::FRD;
  return (is_turned ? orientation * monitor::halfTurnAboutX() : orientation).normalized().toRotationMatrix();
}

// Zeros of which nothing tells how good they are: a field that nobody fills.
bool isUnfilled(const geometry_msgs::TwistWithCovariance& twist)
{
  const auto isZero = [](const geometry_msgs::Vector3& v) { return v.x == 0.0 && v.y == 0.0 && v.z == 0.0; };
  return isZero(twist.twist.linear) && isZero(twist.twist.angular) && block(twist.covariance, 0).isZero(0.0);
}
}  // namespace

Result MotionInputAdapter::take(Body body, const geometry_msgs::PoseStamped& message, const ros::Time& now,
                                const Source& source)
{
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header = message.header;
  pose.pose.pose = message.pose;
  return take(body, pose, now, source);
}

Result MotionInputAdapter::take(Body body, const geometry_msgs::PointStamped& message, const ros::Time& now,
                                const Source& source)
{
  geometry_msgs::PoseWithCovarianceStamped pose;
  pose.header = message.header;
  pose.pose.pose.position = message.point;
  return take(body, pose, now, source);
}

Result MotionInputAdapter::readPose(Body body, const std_msgs::Header& header,
                                    const geometry_msgs::PoseWithCovariance& message, const ros::Time& now,
                                    const Source& source, Eigen::Isometry3d& to_world,
                                    monitor::PoseMeasurement& pose) const
{
  if (const Result error = headers().check(header, now, to_world))
    return error;
  pose.t = timeOf(header.stamp, source);
  pose.position =
      measuredVector(vector(message.pose.position), block(message.covariance, 0), to_world, NOT_MEASURED_STDDEV);
  if (const Result error = outOfBounds(Field::POSITION, pose.position))
    return error;
  pose.orientation = orientationOf(message.pose.orientation, to_world, config(body));
  const monitor::MeasuredVector angles =
      measuredVector(core::Vector3::Zero(), block(message.covariance, 3), to_world, NOT_MEASURED_ANGLE);
  if (!angles.isComplete())
    pose.orientation.reset();
  return std::nullopt;
}

Result MotionInputAdapter::take(Body body, const geometry_msgs::PoseWithCovarianceStamped& message,
                                const ros::Time& now, const Source& source)
{
  Eigen::Isometry3d to_world, mount;
  monitor::PoseMeasurement pose;
  if (const Result error = readPose(body, message.header, message.pose, now, source, to_world, pose))
    return error;
  if (const Result error = mounts().find(config(body), source.frame, mount))
    return error;
  if (source.frame.empty())
    return give(body, pose, source);

  core::Vector3 from_reference;
  if (pose.orientation)
  {
    const bool is_turned = config(body).body_axes == monitor::BodyAxes::FRD;
    const Eigen::Quaterniond sensor =
        is_turned ? *pose.orientation * monitor::halfTurnAboutX() : *pose.orientation;
    pose.orientation = sensor * Eigen::Quaterniond(mount.rotation()).conjugate();
    from_reference = pose.orientation->normalized() * mount.translation();
  }
  else if (const Result error = lever(body, source.frame, pose.t, from_reference))
  {
    return error;
  }
  pose.position = pose.position.at(pose.position.value() - from_reference);
  return give(body, pose, source);
}

// A velocity log on the body: its axes turn with the body.
Result MotionInputAdapter::twistAxes(Body body, const std_msgs::Header& header, double t, Axes& axes) const
{
  const monitor::BodyConfig& own = config(body);
  const bool is_sensor = header.frame_id != own.frame && mounts().isOn(own, header.frame_id);
  if (header.frame_id != own.frame && !is_sensor)
  {
    Eigen::Isometry3d to_world;
    const Result error = headers().transformToWorld(header, to_world);
    axes.to_world = to_world.rotation();
    return error;
  }
  if (own.twist_frame == monitor::TwistFrame::WORLD && !is_sensor)
    return std::nullopt;
  if (!track(body).hasOrientation())
    return "a twist in the body's frame before any pose or attitude";
  // As the message came: what a body turns until the next pose is not known.
  const Eigen::Quaterniond orientation = is_sensor ? track(body).orientationAt(t) : track(body).lastOrientation();
  if (!is_sensor)
  {
    axes.to_world = messageAxesToWorld(own, orientation);
    return std::nullopt;
  }
  Eigen::Isometry3d mount;
  const Result error = mounts().find(own, header.frame_id, mount);
  axes.to_world = (orientation * Eigen::Quaterniond(mount.rotation())).normalized().toRotationMatrix();
  axes.lever = orientation * mount.translation();
  return error;
}

Result MotionInputAdapter::take(Body body, const geometry_msgs::TwistStamped& message, const ros::Time& now,
                                const Source& source)
{
  geometry_msgs::TwistWithCovarianceStamped twist;
  twist.header = message.header;
  twist.twist.twist = message.twist;
  return take(body, twist, now, source);
}

Result MotionInputAdapter::take(Body body, const geometry_msgs::TwistWithCovarianceStamped& message,
                                const ros::Time& now, const Source& source)
{
  std_msgs::Header header = message.header;
  header.frame_id = sensorFrame(message.header, source);
  if (const Result error = headers().checkStamp(header, now))
    return error;
  monitor::TwistMeasurement rates;
  rates.t = timeOf(header.stamp, source);
  Axes axes;
  if (const Result error = twistAxes(body, header, rates.t, axes))
    return error;
  const core::Matrix3 covariance = block(message.twist.covariance, 0);
  rates.velocity =
      measuredVector(vector(message.twist.twist.linear), covariance, isometry(axes.to_world), NOT_MEASURED_STDDEV);
  rates.angular_velocity = axes.to_world * vector(message.twist.twist.angular);
  if (const Result error = outOfBounds(rates))
    return error;
  if (!axes.lever.isZero(0.0))
  {
    // A velocity log does not turn by itself: the body tells how it turns.
    const core::Vector3 turning =
        track(body).hasPose() ? track(body).at(rates.t).angular_velocity : core::Vector3::Zero();
    rates.velocity = rates.velocity.at(rates.velocity.value() - turning.cross(axes.lever));
    rates.angular_velocity = turning;
  }
  return give(body, rates, source);
}

Result MotionInputAdapter::take(Body body, const nav_msgs::Odometry& message, const ros::Time& now,
                                const Source& source)
{
  const auto& twist = message.twist.twist;
  Eigen::Isometry3d to_world;
  monitor::PoseMeasurement pose;
  if (const Result error = readPose(body, message.header, message.pose, now, source, to_world, pose))
    return error;

  const Eigen::Quaterniond orientation = pose.orientation.value_or(track(body).lastOrientation());
  const core::Matrix3 body_to_world = config(body).twist_frame == monitor::TwistFrame::WORLD
                                          ? core::Matrix3(to_world.rotation())
                                          : messageAxesToWorld(config(body), orientation);
  monitor::TwistMeasurement rates;
  rates.t = pose.t;
  rates.velocity = measuredVector(vector(twist.linear), block(message.twist.covariance, 0),
                                  isometry(body_to_world), NOT_MEASURED_STDDEV);
  rates.angular_velocity = body_to_world * vector(twist.angular);
  const bool knows_axes = pose.orientation || track(body).hasOrientation();
  if (rates.velocity.isEmpty() || block(message.twist.covariance, 0).hasNaN() || isUnfilled(message.twist) ||
      !knows_axes)
    return give(body, pose, source);
  if (const Result error = outOfBounds(rates))
    return error;
  return give(body, pose, rates, source);
}

}  // namespace tether_monitor
