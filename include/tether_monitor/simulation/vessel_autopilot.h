#pragma once

#include "tether_monitor/core/bodies/rigid_body.h"
#include "tether_monitor/monitor/measurements/body_state.h"
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
  core::Vector3 stationKeepingForce(const monitor::BodyState& vessel, double dt);

  VesselPlan plan_;
  core::RigidBody ship_;
  double water_density_;
  std::size_t next_ = 0;
  double pull_ = 0.0;                            // what else it takes to keep the speed [N]
  core::Vector3 drift_ = core::Vector3::Zero();  // integral of the distance from the station [m s]
};

}  // namespace tether_monitor::simulation
