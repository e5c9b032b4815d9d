#include "tether_monitor/ros/sensor_input_adapter.h"

#include <cmath>

#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
namespace
{
using Result = std::optional<InputError>;

// Sensors say so in the first entry of a covariance.
bool isAbsent(const boost::array<double, 9>& covariance)
{
  return covariance[0] == -1.0;
}

// What floats is where its body is configured to be, to within its motion in the waves.
monitor::MeasuredVector withoutHeight(const monitor::MeasuredVector& measured, const std::optional<double>& height)
{
  constexpr double FLOATING_STDDEV = 0.2;  // [m]
  monitor::MeasuredVector place = measured;
  place.setNotMeasured(2);
  if (!height)
    return place;
  core::Vector3 value = place.value();
  value.z() = *height;
  core::Matrix3 covariance = place.covariance();
  covariance(2, 2) = FLOATING_STDDEV * FLOATING_STDDEV;
  monitor::MeasuredVector floating(value, covariance);
  for (int axis = 0; axis < 2; ++axis)
    if (place.accuracy(axis) == monitor::Accuracy::UNSPECIFIED)
      floating.setUnspecified(axis);
    else if (!place.isMeasured(axis))
      floating.setNotMeasured(axis);
  return floating;
}

// Half a turn about the line between north and east.
const Eigen::Quaterniond NORTH_EAST_DOWN_TO_EAST_NORTH_UP(0.0, std::sqrt(0.5), std::sqrt(0.5), 0.0);
}  // namespace

SensorInputAdapter::SensorInputAdapter(monitor::TetherEstimator& estimator, const HeaderCheck& headers,
                                       const SensorMounts& mounts, const TimeOrigin& time, RecentFixes& fixes)
  : BodyInput(estimator, headers, mounts, time, fixes)
{
  if (estimator.config().inputs.datum)
    datum_.emplace(*estimator.config().inputs.datum);
}

Result SensorInputAdapter::take(Body body, const sensor_msgs::NavSatFix& message, const ros::Time& now,
                                const Source& source)
{
  if (!datum_)
    return "a NavSatFix, and no datum in the parameters (latitude and longitude of the origin of '" +
           config().world_frame + "')";
  if (const Result error = headers().checkStamp(message.header, now))
    return error;
  if (message.status.status < sensor_msgs::NavSatStatus::STATUS_FIX)
    return "the receiver has no fix (status.status = " + std::to_string(message.status.status) + ")";
  const bool is_on_globe = std::abs(message.latitude) <= 90.0 && std::abs(message.longitude) <= 180.0;
  if (!is_on_globe)
    return "latitude " + std::to_string(message.latitude) + ", longitude " + std::to_string(message.longitude) +
           " is no place";
  monitor::PoseMeasurement pose;
  pose.t = timeOf(message.header.stamp, source);
  pose.orientation.reset();
  core::Vector3 place = datum_->horizontal(message.latitude, message.longitude);
  const std::optional<double> still_water = config().inputs.datum->altitude;
  const bool has_height = still_water && std::isfinite(message.altitude);
  place.z() = has_height ? message.altitude - *still_water : 0.0;
  if (const Result error = outOfBounds(Field::POSITION, place))
    return error;
  const core::Matrix3 covariance =
      message.position_covariance_type == sensor_msgs::NavSatFix::COVARIANCE_TYPE_UNKNOWN
          ? core::Matrix3(core::Matrix3::Zero())
          : block(message.position_covariance);
  core::Vector3 from_reference;
  if (const Result error = lever(body, sensorFrame(message.header, source), pose.t, from_reference))
    return error;
  pose.position = measuredVector(core::Vector3::Zero(), covariance, isometry(datum_->eastNorthUpToWorld()),
                                 NOT_MEASURED_STDDEV)
                      .at(place - from_reference);
  if (!has_height)
    pose.position = withoutHeight(pose.position, config(body).height);
  return give(body, pose, source);
}

Result SensorInputAdapter::take(Body body, const sensor_msgs::Imu& message, const ros::Time& now,
                                const Source& source)
{
  if (const Result error = headers().checkStamp(message.header, now))
    return error;
  const Eigen::Quaterniond sensor = quaternion(message.orientation);
  if (isAbsent(message.orientation_covariance) || sensor.coeffs().isZero(0.0))
    return "it has no orientation: without one an Imu says nothing of the attitude";
  if (!sensor.coeffs().allFinite() || std::abs(sensor.norm() - 1.0) > 0.01)
    return describe(monitor::Rejection::BAD_QUATERNION);
  Eigen::Isometry3d mount;
  if (const Result error = mounts().find(config(body), sensorFrame(message.header, source), mount))
    return error;
  Eigen::Quaterniond reference(datum_ ? datum_->eastNorthUpToWorld() : core::Matrix3::Identity());
  if (config(body).body_axes == monitor::BodyAxes::FRD)
    reference = reference * NORTH_EAST_DOWN_TO_EAST_NORTH_UP;
  const Eigen::Quaterniond sensor_to_world = reference * sensor.normalized();
  monitor::PoseMeasurement attitude;
  attitude.t = timeOf(message.header.stamp, source);
  attitude.orientation = sensor_to_world * Eigen::Quaterniond(mount.rotation()).conjugate();
  if (!isAbsent(message.angular_velocity_covariance))
  {
    const core::Vector3 turning = sensor_to_world * vector(message.angular_velocity);
    if (const Result error = outOfBounds(Field::ANGULAR_VELOCITY, turning))
      return error;
    attitude.angular_velocity = turning;
  }
  return give(body, attitude, source);
}

Result SensorInputAdapter::giveHeight(Body body, double t, double height, std::optional<double> stddev,
                                      const Source& source)
{
  if (const Result error = outOfBounds(Field::DEPTH, height))
    return error;
  monitor::PoseMeasurement pose;
  pose.t = t;
  pose.orientation.reset();
  pose.position = core::Vector3(0.0, 0.0, height);
  if (stddev)
    pose.position = pose.position.withDefaultStddev(*stddev);
  pose.position.setNotMeasured(0);
  pose.position.setNotMeasured(1);
  return give(body, pose, source);
}

Result SensorInputAdapter::take(Body body, const std_msgs::Float64& message, const ros::Time& now,
                                const Source& source)
{
  core::Vector3 from_reference;
  const double t = timeOf(now, source);
  if (const Result error = lever(body, source.frame, t, from_reference))
    return error;
  return giveHeight(body, t, -source.scale * message.data - from_reference.z(), std::nullopt, source);
}

Result SensorInputAdapter::take(Body body, const sensor_msgs::FluidPressure& message, const ros::Time& now,
                                const Source& source)
{
  if (const Result error = headers().checkStamp(message.header, now))
    return error;
  const core::Environment& sea = config().environment;
  const double weight = sea.water_density * sea.gravity;  // [Pa/m]
  const double depth = (source.scale * message.fluid_pressure - config().inputs.air_pressure) / weight;
  core::Vector3 from_reference;
  const double t = timeOf(message.header.stamp, source);
  if (const Result error = lever(body, sensorFrame(message.header, source), t, from_reference))
    return error;
  const bool is_told = message.variance > 0.0 && std::isfinite(message.variance);
  const std::optional<double> stddev =
      is_told ? std::optional<double>(std::abs(source.scale) * std::sqrt(message.variance) / weight)
              : std::nullopt;
  return giveHeight(body, t, -depth - from_reference.z(), stddev, source);
}

Result SensorInputAdapter::take(Body body, const AcousticFix& message, const ros::Time& now, const Source& source)
{
  Eigen::Isometry3d to_world;
  if (const Result error = headers().check(message.header, now, to_world))
    return error;
  if (!(message.range > 0.0))
    return "range = " + std::to_string(message.range) + " (must be > 0 m)";
  if (!(std::abs(message.bearing) <= 2.0 * M_PI && std::abs(message.elevation) <= M_PI))
    return "bearing or elevation is no angle (they are in rad)";
  const double cb = std::cos(message.bearing), sb = std::sin(message.bearing);
  const double ce = std::cos(message.elevation), se = std::sin(message.elevation);
  const core::Vector3 along(ce * cb, ce * sb, se);
  core::Matrix3 J;
  J.col(0) = along;
  J.col(1) = message.range * core::Vector3(-ce * sb, ce * cb, 0.0);
  J.col(2) = message.range * core::Vector3(-se * cb, -se * sb, ce);
  monitor::PoseMeasurement pose;
  pose.t = timeOf(message.header.stamp, source);
  pose.orientation.reset();
  pose.position = measuredVector(message.range * along, J * block(message.covariance) * J.transpose(), to_world,
                                 NOT_MEASURED_STDDEV);
  if (const Result error = outOfBounds(Field::POSITION, pose.position))
    return error;
  core::Vector3 from_reference;
  if (const Result error = lever(body, source.frame, pose.t, from_reference))
    return error;
  pose.position = pose.position.at(pose.position.value() - from_reference);
  return give(body, pose, source);
}

}  // namespace tether_monitor
