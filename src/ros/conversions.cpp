#include "tether_monitor/ros/conversions.h"

#include <cmath>
#include <cstdio>
#include <limits>

namespace tether_monitor
{
static_assert(static_cast<int>(monitor::Status::INVALID) == TetherState::STATUS_INVALID, "status codes differ");
static_assert(static_cast<int>(monitor::Reason::CLOCK_JUMP) == TetherState::REASON_CLOCK_JUMP,
              "reason codes differ");
static_assert(static_cast<int>(monitor::AlarmState::RETURNED_UNACKNOWLEDGED) == Alarm::RETURNED_UNACKNOWLEDGED,
              "alarm state codes differ");
static_assert(static_cast<int>(monitor::Severity::CRITICAL) == Alarm::CRITICAL, "severity codes differ");

Eigen::Vector3d vector(const geometry_msgs::Point& p)
{
  return {p.x, p.y, p.z};
}

Eigen::Vector3d vector(const geometry_msgs::Vector3& v)
{
  return {v.x, v.y, v.z};
}

Eigen::Quaterniond quaternion(const geometry_msgs::Quaternion& q)
{
  return {q.w, q.x, q.y, q.z};
}

Eigen::Isometry3d isometry(const geometry_msgs::Transform& transform)
{
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = vector(transform.translation);
  result.linear() = quaternion(transform.rotation).normalized().toRotationMatrix();
  return result;
}

geometry_msgs::Point pointMessage(const Eigen::Vector3d& v)
{
  geometry_msgs::Point point;
  point.x = v.x();
  point.y = v.y();
  point.z = v.z();
  return point;
}

geometry_msgs::Vector3 vectorMessage(const Eigen::Vector3d& v)
{
  geometry_msgs::Vector3 message;
  message.x = v.x();
  message.y = v.y();
  message.z = v.z();
  return message;
}

void toMessage(const monitor::TetherEstimate& e, TetherState& out)
{
  constexpr double NONE = monitor::TetherEstimate::NONE;
  const core::StationField& at = e.stations;
  const std::size_t n = e.has_stations ? at.s.size() : 0;
  out.status = static_cast<uint8_t>(e.status);
  out.reason = static_cast<uint8_t>(e.reason);
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
  {
    out.position[i] = pointMessage(at.position[i]);
  }
  out.vehicle_relative =
      vectorMessage(n > 0 ? core::Vector3(at.position[n - 1] - at.position[0]) : core::Vector3::Constant(NONE));
  out.vessel_tension = e.vessel_tension;
  out.vehicle_tension = e.vehicle_tension;
  out.max_tension = e.max_tension;
  out.max_tension_s = e.max_tension_s;
  out.working_utilisation = e.working_utilisation;
  out.breaking_utilisation = e.breaking_utilisation;
  out.min_bend_radius = e.min_bend_radius;
  out.min_bend_radius_s = e.min_bend_radius_s;
  out.vessel_end_angle = e.vessel_end_angle;
  out.vehicle_end_angle = e.vehicle_end_angle;
  out.seabed_contact_length = e.has_stations ? 0.0 : NONE;
  out.touchdown_s = NONE;
  out.vessel_age = std::isnan(e.vessel_age) ? std::numeric_limits<double>::infinity() : e.vessel_age;
  out.vehicle_age = std::isnan(e.vehicle_age) ? std::numeric_limits<double>::infinity() : e.vehicle_age;
}

geometry_msgs::WrenchStamped wrenchMessage(const std_msgs::Header& header, const monitor::TetherEstimate& estimate,
                                           const core::Vector3& force)
{
  constexpr double NONE = monitor::TetherEstimate::NONE;
  geometry_msgs::WrenchStamped message;
  message.header = header;
  message.wrench.force = vectorMessage(estimate.has_stations ? force : core::Vector3::Constant(NONE));
  message.wrench.torque =
      vectorMessage(estimate.has_stations ? core::Vector3::Zero() : core::Vector3::Constant(NONE));
  return message;
}

const char* lifeForPerson(monitor::AlarmState state)
{
  switch (state)
  {
    case monitor::AlarmState::NORMAL:
      return "normal";
    case monitor::AlarmState::UNACKNOWLEDGED:
      return "ACTIVE";
    case monitor::AlarmState::ACKNOWLEDGED:
      return "active, acknowledged";
    case monitor::AlarmState::RETURNED_UNACKNOWLEDGED:
      return "back in limits, not acknowledged";
  }
  return "unknown";
}

std::string describeForPerson(const monitor::Alarm& alarm)
{
  const monitor::AlarmDefinition& d = alarm.definition();
  const char* side = d.side == monitor::Side::ABOVE ? "above" : "below";
  char text[200];
  const int used = std::snprintf(text, sizeof(text), "%s %s: %.3g, limit %s %.3g", d.name.c_str(),
                                 lifeForPerson(alarm.state()), alarm.value(), side, d.limit);
  if (!std::isnan(alarm.s()))
    std::snprintf(text + used, sizeof(text) - used, ", at s = %.1f m", alarm.s());
  return text;
}

AlarmArray toMessage(const monitor::AlarmSet& set, const TimeBase& time)
{
  AlarmArray array;
  for (const monitor::Alarm& alarm : set.alarms())
  {
    Alarm message;
    message.name = alarm.definition().name;
    message.state = static_cast<uint8_t>(alarm.state());
    message.severity = static_cast<uint8_t>(alarm.definition().severity);
    message.value = alarm.value();
    message.limit = alarm.definition().limit;
    message.s = alarm.s();
    message.since = time.stamp(alarm.since());
    message.text = describeForPerson(alarm);
    array.alarms.push_back(message);
  }
  return array;
}

}  // namespace tether_monitor
