#include "tether_monitor/ros/message_conversions.h"

#include <cmath>
#include <limits>

#include "tether_monitor/monitor/measurements/rejection.h"
#include "tether_monitor/ros/geometry_conversions.h"

namespace tether_monitor
{
static_assert(static_cast<int>(monitor::Status::INVALID) == TetherState::STATUS_INVALID, "status codes differ");
static_assert(static_cast<int>(monitor::Reason::IMPLAUSIBLE) == TetherState::REASON_IMPLAUSIBLE,
              "reason codes differ");
static_assert(static_cast<int>(monitor::Status::STOWED) == TetherState::STATUS_STOWED, "status codes differ");

namespace
{
constexpr double LEAST_CONTACT_PROBABILITY = 0.05;
}

void toMessage(const monitor::TetherEstimate& e, TetherState& out)
{
  constexpr double NONE = monitor::TetherEstimate::NONE;
  const core::StationProfile& at = e.stations;
  const std::size_t n = e.has_stations ? at.s.size() : 0;
  out.status = static_cast<uint8_t>(e.status);
  out.reason = static_cast<uint8_t>(e.reason);
  out.reasons = e.reasons.bits();
  out.is_stowed = e.is_stowed;
  out.length = e.length;
  out.stretched_length = e.has_stations ? at.stretched_length : NONE;
  out.payout_rate = e.payout_rate;
  out.s.assign(at.s.begin(), at.s.begin() + n);
  out.tension.assign(at.tension.begin(), at.tension.begin() + n);
  out.strain.assign(at.strain.begin(), at.strain.begin() + n);
  out.bend_radius.assign(at.bend_radius.begin(), at.bend_radius.begin() + n);
  out.position.resize(n);
  out.stress.assign(at.stress.begin(), at.stress.begin() + n);
  for (std::size_t i = 0; i < n; ++i)
    out.position[i] = pointMessage(at.position[i]);
  out.vehicle_relative =
      vectorMessage(n > 0 ? core::Vector3(at.position[n - 1] - at.position[0]) : core::Vector3::Constant(NONE));
  out.vessel_tension = e.vessel_tension;
  out.vehicle_tension = e.vehicle_tension;
  out.vessel_tension_stddev = e.vessel_tension_stddev;
  out.vehicle_tension_stddev = e.vehicle_tension_stddev;
  out.vehicle_position_stddev = e.vehicle_position_stddev;
  out.tension_stddev.assign(e.has_stations ? e.tension_stddev.begin() : e.tension_stddev.end(),
                            e.tension_stddev.end());
  out.position_stddev.clear();
  for (std::size_t i = 0; e.has_stations && i < e.position_stddev.size(); ++i)
    out.position_stddev.push_back(vectorMessage(e.position_stddev[i]));
  out.vessel_tension_p05 = e.vessel_tension_p05;
  out.vessel_tension_p95 = e.vessel_tension_p95;
  out.vehicle_tension_p05 = e.vehicle_tension_p05;
  out.vehicle_tension_p95 = e.vehicle_tension_p95;
  out.max_tension_p95 = e.max_tension_p95;
  out.max_tension = e.max_tension;
  out.max_tension_s = e.max_tension_s;
  out.working_utilisation = e.working_utilisation;
  out.breaking_utilisation = e.breaking_utilisation;
  out.min_bend_radius = e.min_bend_radius;
  out.min_bend_radius_s = e.min_bend_radius_s;
  out.vessel_end_angle = e.vessel_end_angle;
  out.vehicle_end_angle = e.vehicle_end_angle;
  out.seabed_contact_length = e.seabed_contact_length;
  out.touchdown_s = e.touchdown_s;
  out.vessel_age = std::isnan(e.vessel_age) ? std::numeric_limits<double>::infinity() : e.vessel_age;
  out.vehicle_age = std::isnan(e.vehicle_age) ? std::numeric_limits<double>::infinity() : e.vehicle_age;
}

ContactArray contactsMessage(const monitor::TetherEstimate& e, const std::vector<core::Obstacle>& obstacles)
{
  ContactArray array;
  for (std::size_t k = 0; k < obstacles.size() && k < e.contact.obstacles.size(); ++k)
  {
    const core::ContactSummary::ObstacleContact& touch = e.contact.obstacles[k];
    const bool touches = touch.total > 0.0;
    const double probability = k < e.contact_probability.size() ? e.contact_probability[k] : (touches ? 1.0 : 0.0);
    if (!e.has_stations || (!touches && probability < LEAST_CONTACT_PROBABILITY))
      continue;
    Contact contact;
    contact.obstacle = obstacles[k].name;
    contact.force = vectorMessage(touch.force);
    contact.place = pointMessage(touch.place);
    contact.s = touch.s;
    contact.largest = touch.largest;
    contact.probability = probability;
    array.contacts.push_back(contact);
  }
  return array;
}

std::optional<std::string> toObstacle(const Obstacle& message, const Eigen::Isometry3d& to_world,
                                      core::Obstacle& obstacle)
{
  const std::string name = "obstacle '" + message.name + "': ";
  if (message.shape > Obstacle::BOX)
    return name + "shape = " + std::to_string(message.shape) + " is not known";
  const std::size_t sizes = message.shape + 1u;
  if (message.size.size() != sizes)
    return name + "size has " + std::to_string(message.size.size()) + " numbers, " + std::to_string(sizes) +
           " are expected";
  obstacle.name = message.name;
  obstacle.shape = static_cast<core::ObstacleShape>(message.shape);
  for (std::size_t i = 0; i < sizes; ++i)
    obstacle.size[static_cast<int>(i)] = message.size[i];
  Eigen::Quaterniond q = quaternion(message.pose.orientation);
  if (q.coeffs().isZero(0.0))
    q.setIdentity();
  if (!(std::abs(q.norm() - 1.0) < 0.01))
    return name + describe(monitor::Rejection::BAD_QUATERNION);
  obstacle.position = to_world * vector(message.pose.position);
  obstacle.orientation = Eigen::Quaterniond(to_world.rotation()) * q.normalized();
  obstacle.velocity = to_world.linear() * vector(message.velocity);
  obstacle.mass = message.mass;
  obstacle.friction = message.friction;
  return std::nullopt;
}

nav_msgs::Odometry vehicleMessage(const std_msgs::Header& header, const monitor::BodyConfig& body,
                                  const monitor::TetherEstimate& e)
{
  nav_msgs::Odometry message;
  message.header = header;
  message.child_frame_id = body.frame;
  message.pose.pose.position = pointMessage(e.vehicle.position);
  const bool is_turned = body.body_axes == monitor::BodyAxes::FRD;
  const Eigen::Quaterniond half_turn = is_turned ? monitor::halfTurnAboutX() : Eigen::Quaterniond::Identity();
  const Eigen::Quaterniond orientation = e.vehicle.orientation * half_turn;
  message.pose.pose.orientation = quaternionMessage(orientation);
  const Eigen::Quaterniond to_body = orientation.conjugate();
  message.twist.twist.linear = vectorMessage(to_body * e.vehicle.velocity);
  message.twist.twist.angular = vectorMessage(to_body * e.vehicle.angular_velocity);
  if (std::isfinite(e.vehicle_position_stddev))
  {
    const core::Matrix3 R = to_body.toRotationMatrix();
    const core::Matrix3 not_measured = NOT_MEASURED_VARIANCE * core::Matrix3::Identity();
    setBlock(e.vehicle_position_covariance, 0, message.pose.covariance);
    setBlock(not_measured, 3, message.pose.covariance);
    setBlock(R * e.vehicle_velocity_covariance * R.transpose(), 0, message.twist.covariance);
    setBlock(not_measured, 3, message.twist.covariance);
  }
  return message;
}

geometry_msgs::WrenchStamped wrenchMessage(const std_msgs::Header& header, const monitor::TetherEstimate& estimate,
                                           const core::Vector3& force, const core::Vector3& moment)
{
  constexpr double NONE = monitor::TetherEstimate::NONE;
  geometry_msgs::WrenchStamped message;
  message.header = header;
  message.wrench.force = vectorMessage(estimate.has_stations ? force : core::Vector3::Constant(NONE));
  message.wrench.torque = vectorMessage(estimate.has_stations ? moment : core::Vector3::Constant(NONE));
  return message;
}

WrenchWithCovarianceStamped bodyWrenchMessage(const std_msgs::Header& header, const monitor::TetherEstimate& e,
                                              const std::optional<Eigen::Quaterniond>& attitude,
                                              const monitor::BodyConfig& body)
{
  WrenchWithCovarianceStamped message;
  message.header = header;
  message.covariance[0] = -1.0;
  const core::Vector3 none = core::Vector3::Constant(monitor::TetherEstimate::NONE);
  message.wrench.force = message.wrench.torque = vectorMessage(none);
  if (!e.has_stations || !attitude)
    return message;
  const Eigen::Quaterniond to_body = attitude->conjugate();
  core::Vector3 force = to_body * e.stations.ends.vehicle, lever = body.attachment;
  core::Vector3 torque = to_body * e.stations.ends.vehicle_moment + lever.cross(force);
  if (body.body_axes == monitor::BodyAxes::FRD)
  {
    force = monitor::turnedAboutX(force);
    torque = monitor::turnedAboutX(torque);
    lever = monitor::turnedAboutX(lever);
  }
  message.wrench.force = vectorMessage(force);
  message.wrench.torque = vectorMessage(torque);
  if (!std::isfinite(e.vehicle_tension_stddev))
    return message;
  core::Matrix3 cross;
  cross << 0.0, -lever.z(), lever.y(), lever.z(), 0.0, -lever.x(), -lever.y(), lever.x(), 0.0;
  Eigen::Matrix<double, 6, 3> effect;
  effect << core::Matrix3::Identity(), cross;
  const Eigen::Matrix<double, 6, 6> covariance =
      std::pow(e.vehicle_tension_stddev, 2) * effect * effect.transpose();
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      message.covariance[6 * i + j] = covariance(i, j);
  return message;
}

ParameterEstimate toMessage(const std_msgs::Header& header, const std::vector<monitor::ParameterEstimate>& report)
{
  ParameterEstimate message;
  message.header = header;
  for (const monitor::ParameterEstimate& entry : report)
  {
    message.name.push_back(entry.name);
    message.mean.push_back(entry.mean);
    message.stddev.push_back(entry.stddev);
    message.configured.push_back(entry.configured);
    message.configured_stddev.push_back(entry.configured_stddev);
  }
  return message;
}

}  // namespace tether_monitor
