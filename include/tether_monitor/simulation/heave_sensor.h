#pragma once

#include <optional>
#include <random>

#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/simulation/simulation_config.h"

namespace tether_monitor::simulation
{
/// A motion sensor: the height of the vessel's reference point. The same seed gives the same noise.
class HeaveSensor
{
 public:
  HeaveSensor(const HeavePlan& plan, unsigned seed);

  /// Looks at the vessel at time t [s], increasing from call to call. @return its height [m], if one is due.
  std::optional<double> sample(double t, const monitor::BodyState& truth);

 private:
  HeavePlan plan_;
  std::mt19937 generator_;
  double next_ = 0.0;
};

}  // namespace tether_monitor::simulation
