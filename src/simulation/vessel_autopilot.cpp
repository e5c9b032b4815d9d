#include "tether_monitor/simulation/vessel_autopilot.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::simulation
{
namespace
{
constexpr double SPEED_TIME = 8.0;          // [s] in which a wrong speed is put right
constexpr double HEADING_TIME = 6.0;        // [s] likewise the heading
constexpr double FASTEST_TURN = 0.06;       // [rad/s]
constexpr double STATION_BANDWIDTH = 0.15;  // [rad/s] of dynamic positioning

double yawOf(const Eigen::Quaterniond& q)
{
  const core::Vector3 ahead = q * core::Vector3::UnitX();
  return std::atan2(ahead.y(), ahead.x());
}

double wrapped(double angle)
{
  return std::remainder(angle, 2.0 * M_PI);
}
}  // namespace

VesselAutopilot::VesselAutopilot(const VesselPlan& plan, const core::RigidBody& ship, double water_density)
  : plan_(plan), ship_(ship), water_density_(water_density)
{
}

core::Wrench VesselAutopilot::steer(const monitor::BodyState& vessel, double dt)
{
  const auto remaining = [&]
  {
    core::Vector3 to = plan_.waypoints[next_].position - vessel.position;
    to.z() = 0.0;
    return to;
  };
  while (next_ < plan_.waypoints.size() && remaining().norm() < plan_.acceptance)
    ++next_;
  double heading = plan_.heading, speed = plan_.waypoints.empty() ? plan_.speed : 0.0;
  const double yaw = yawOf(vessel.orientation);
  if (next_ < plan_.waypoints.size())
  {
    heading = std::atan2(remaining().y(), remaining().x());
    speed = plan_.waypoints[next_].speed;
  }
  else if (!plan_.waypoints.empty())
  {
    heading = yaw;
  }
  const core::Vector3 ahead(std::cos(yaw), std::sin(yaw), 0.0);
  const double now = vessel.velocity.dot(ahead);
  const double mass = ship_.mass + ship_.added_mass.x();
  const double error = speed - now;
  pull_ += mass / (SPEED_TIME * 3.0 * SPEED_TIME) * error * dt;
  core::Wrench thrust;
  thrust.force.x() =
      mass / SPEED_TIME * error + 0.5 * water_density_ * ship_.drag_area.x() * std::abs(now) * now + pull_;

  const double inertia = ship_.inertia.z() + ship_.added_inertia.z();
  const double rate = std::clamp(wrapped(heading - yaw) / HEADING_TIME, -FASTEST_TURN, FASTEST_TURN);
  thrust.torque.z() = inertia / (0.3 * HEADING_TIME) * (rate - vessel.angular_velocity.z());
  if (plan_.waypoints.empty() && plan_.speed == 0.0)
    thrust.force = stationKeepingForce(vessel, dt);
  // A ship that slips sideways wants to turn further across: the rudder holds against it.
  const core::Vector3 u = vessel.orientation.conjugate() * vessel.velocity;
  thrust.torque.z() += (ship_.added_mass.y() - ship_.added_mass.x()) * u.x() * u.y();
  return thrust;
}

// Dynamic positioning at the start.
core::Vector3 VesselAutopilot::stationKeepingForce(const monitor::BodyState& vessel, double dt)
{
  core::Vector3 off = plan_.start - vessel.position;
  off.z() = 0.0;
  drift_ += dt * off;
  const double w = STATION_BANDWIDTH;
  const core::Vector3 m = core::Vector3::Constant(ship_.mass) + ship_.added_mass;
  const core::Vector3 push = w * w * off - 1.6 * w * vessel.velocity + 0.1 * w * w * w * drift_;
  core::Vector3 force = m.cwiseProduct(vessel.orientation.conjugate() * push);
  force.z() = 0.0;
  return force;
}

}  // namespace tether_monitor::simulation
