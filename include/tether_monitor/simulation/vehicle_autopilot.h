#pragma once

#include "tether_monitor/monitor/measurements/body_state.h"
#include "tether_monitor/simulation/simulation_config.h"

namespace tether_monitor::simulation
{
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
