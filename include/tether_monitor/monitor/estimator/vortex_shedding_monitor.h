#pragma once

#include <limits>

#include "tether_monitor/core/analysis/vortex_shedding.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// Finds once a second of model time where vortices shed in step with the tether, and amplifies the drag there.
class VortexSheddingMonitor
{
 public:
  explicit VortexSheddingMonitor(double amplification) : amplification_(amplification) {}

  /// Begins with what a start has found; the next update() looks again.
  void begin(const core::VortexShedding& found);
  void update(CableSimulation& simulation);
  /// As it was at the last update.
  const core::VortexShedding& last() const { return last_; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(time_, last_);
  }

 private:
  double amplification_;
  double time_ = -std::numeric_limits<double>::infinity();  // of the last update [s]
  core::VortexShedding last_;
};

}  // namespace tether_monitor::monitor
