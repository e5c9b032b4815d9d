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

/// How the node runs; it changes no number.
struct RuntimeConfig
{
  int priority = 0;          ///< of the estimator's thread, SCHED_FIFO, 0..99; 0: as any other.
  bool lock_memory = false;  ///< keeps all pages of the process in memory.
  std::string state_file;    ///< where the state is kept for a restart; empty: nowhere.
  BridgeConfig bridge;
};

}  // namespace tether_monitor::monitor
