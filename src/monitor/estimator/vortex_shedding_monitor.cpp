#include "tether_monitor/monitor/estimator/vortex_shedding_monitor.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double PERIOD = 1.0;  // [s]
}

void VortexSheddingMonitor::begin(const core::VortexShedding& found)
{
  time_ = -std::numeric_limits<double>::infinity();
  last_ = found;
}

void VortexSheddingMonitor::update(CableSimulation& simulation)
{
  core::CableState& state = simulation.state;
  if (state.time < time_ + PERIOD && state.time >= time_)
    return;
  time_ = state.time;
  last_ = core::findLockIn(simulation.updatedCable(), state, amplification_, state.deployment.drag_factor);
}

}  // namespace tether_monitor::monitor
