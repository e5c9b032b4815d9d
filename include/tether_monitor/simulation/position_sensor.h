#pragma once

#include <deque>
#include <optional>
#include <random>
#include <vector>

#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/simulation/simulation_config.h"

namespace tether_monitor::simulation
{
/// A measurement on its way.
struct Measurement
{
  double time = 0.0;  ///< when it was taken [s].
  monitor::BodyState body;
  bool has_velocity = false;
};

/// Measures a body as its plan says: rate, noise, dropouts, outliers, gap, latency. The same seed gives the same.
class Sensor
{
 public:
  Sensor(const SensorModel& plan, unsigned seed);

  /// Looks at the body at time t [s], increasing from call to call. @return the measurements that arrive by now.
  std::vector<Measurement> sample(double t, const monitor::BodyState& truth);

 private:
  Measurement measure(double t, const monitor::BodyState& truth);
  core::Vector3 noise(double stddev);

  SensorModel plan_;
  std::mt19937 generator_;
  double next_ = 0.0;
  std::deque<Measurement> on_the_way_;
};

}  // namespace tether_monitor::simulation
