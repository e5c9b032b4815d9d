#pragma once

#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/simulation/simulation_config.h"

namespace tether_monitor::simulation
{
/// Steers a vessel along its waypoints: thrust along its axis for the speed, a yaw moment for the heading. One
/// that has neither waypoints nor speed keeps its station.
class VesselAutopilot
{
 public:
  VesselAutopilot(const VesselPlan& plan, const core::RigidBody& ship, double water_density);

  /// Thrust for the next dt [s], body axes.
  core::Wrench steer(const monitor::BodyState& vessel, double dt);

 private:
  VesselPlan plan_;
  core::RigidBody ship_;
  double water_density_;
  std::size_t next_ = 0;
  double pull_ = 0.0;                            // what else it takes to keep the speed [N]
  core::Vector3 drift_ = core::Vector3::Zero();  // integral of the distance from the station [m s]
};

/// Keeps a vehicle at a point that moves from waypoint to waypoint, level and on its heading.
class VehicleAutopilot
{
 public:
  /// @param balance  force that keeps it at its start [N], world frame.
  VehicleAutopilot(const VehiclePlan& plan, const core::Vector3& balance);

  /// Thrust for the next dt [s], body axes.
  core::Wrench steer(const monitor::BodyState& vehicle, double dt);
  const core::Vector3& target() const { return target_; }

 private:
  VehiclePlan plan_;
  core::Vector3 target_, target_velocity_ = core::Vector3::Zero();
  core::Vector3 balance_;
  std::size_t next_ = 0;
};

}  // namespace tether_monitor::simulation
