#pragma once

#include <string>

namespace tether_monitor::monitor
{
/// Topics on which a simulator accepts forces; empty: none.
struct BridgeConfig
{
  std::string vessel;        ///< on the vessel, world axes, about the attachment.
  std::string vehicle;       ///< on the vehicle, likewise.
  std::string vehicle_body;  ///< on the vehicle, its own axes.
};

/// What is published beside the messages of the package, for tools that know standard ones.
struct StandardOutputsConfig
{
  bool path = false;         ///< the tether as a nav_msgs/Path.
  bool vessel_pose = false;  ///< where the vessel is, with covariance.
  bool tf = false;           ///< frames at both ends of the tether.
};

/// How the node runs; it changes no number.
struct RuntimeConfig
{
  int priority = 0;          ///< of the estimator's thread, SCHED_FIFO, 0..99; 0: as any other.
  bool lock_memory = false;  ///< keeps all pages of the process in memory.
  std::string state_file;    ///< where the state is kept for a restart; empty: nowhere.
  BridgeConfig bridge;
  StandardOutputsConfig outputs;
};

}  // namespace tether_monitor::monitor
