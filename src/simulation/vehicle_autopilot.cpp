#include "tether_monitor/simulation/vehicle_autopilot.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::simulation
{
namespace
{
constexpr double BANDWIDTH = 0.8;  // [rad/s] of the position control
}

VehicleAutopilot::VehicleAutopilot(const VehiclePlan& plan, const core::Vector3& balance)
  : plan_(plan), target_(plan.start), balance_(balance)
{
}

core::Wrench VehicleAutopilot::steer(const monitor::BodyState& vehicle, double dt)
{
  core::Vector3 wanted = core::Vector3::Zero();
  if (next_ < plan_.waypoints.size())
  {
    const Waypoint& waypoint = plan_.waypoints[next_];
    const core::Vector3 remaining = waypoint.position - target_;
    if ((waypoint.position - vehicle.position).norm() < plan_.acceptance)
      ++next_;
    else
      wanted = std::min(waypoint.speed, 0.4 * remaining.norm()) * remaining.normalized();
    if (remaining.norm() < 1e-9)
      wanted.setZero();
  }
  target_velocity_ += std::min(dt / 2.0, 1.0) * (wanted - target_velocity_);
  // The target waits for a vehicle that cannot follow.
  const double leash = std::clamp(1.5 - 0.5 * (target_ - vehicle.position).norm(), 0.0, 1.0);
  target_ += leash * dt * target_velocity_;

  const double w = BANDWIDTH;
  const core::RigidBody& body = plan_.body;
  const core::Vector3 mass = core::Vector3::Constant(body.mass) + body.added_mass;
  const core::Vector3 error = target_ - vehicle.position;
  balance_ += mass.mean() * 0.15 * w * w * w * dt * error;
  balance_ = balance_.cwiseMax(-plan_.largest_thrust).cwiseMin(plan_.largest_thrust);
  const core::Vector3 force =
      mass.mean() * (w * w * error + 1.6 * w * (leash * target_velocity_ - vehicle.velocity)) + balance_;
  core::Wrench thrust;
  thrust.force = vehicle.orientation.conjugate() * force;
  if (thrust.force.norm() > plan_.largest_thrust)
    thrust.force *= plan_.largest_thrust / thrust.force.norm();

  const core::Vector3 spin = vehicle.orientation.conjugate() * vehicle.angular_velocity;
  Eigen::Quaterniond off = vehicle.orientation.conjugate();  // level, heading zero
  if (off.w() < 0.0)
    off.coeffs() *= -1.0;
  const core::Vector3 inertia = body.inertia + body.added_inertia;
  thrust.torque = inertia.cwiseProduct(w * w * 2.0 * off.vec() - 1.6 * w * spin);
  return thrust;
}

}  // namespace tether_monitor::simulation
