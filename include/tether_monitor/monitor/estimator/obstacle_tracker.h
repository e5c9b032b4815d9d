#pragma once

#include <limits>
#include <string>
#include <vector>

#include "tether_monitor/core/environment/obstacle.h"
#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/model/cable_simulation.h"

namespace tether_monitor::monitor
{
/// Keeps the places of the obstacles: what the messages say, and where they have gone since.
class ObstacleTracker
{
 public:
  /**
   * Replaces the obstacles, whose places are those of time t [s]. One with the name of an old one keeps the
   * friction of the tether on it.
   *
   * @param running     the tether of the simulation is in motion.
   * @return what is wrong with them, and nothing changes; empty if nothing is.
   */
  std::vector<std::string> set(double t, const std::vector<core::Obstacle>& obstacles, bool running,
                               CableSimulation& simulation, VehicleEnd& vehicle);
  /// The obstacles at time t [s]: those that are pushed from where they were last, the others on their way.
  std::vector<core::Obstacle> at(double t, const CableSimulation& simulation) const;
  /// The simulation has begun with the places of time t [s].
  void begin(double t) { time_ = t; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(time_);
  }

 private:
  double time_ = std::numeric_limits<double>::quiet_NaN();  // of the places in the model [s]; NaN: since ever
};

}  // namespace tether_monitor::monitor
