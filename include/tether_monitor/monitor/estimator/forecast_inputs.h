#pragma once

#include "tether_monitor/monitor/estimator/vehicle_end.h"
#include "tether_monitor/monitor/forecast/forecast_start.h"

namespace tether_monitor::monitor
{
/// Watches the ends of a tether in motion, and copies what a forecast begins with. Plain data: copy it to save it.
class ForecastInputs
{
 public:
  /// The simulation has come to a new time.
  void observe(const CableSimulation& simulation, const VehicleEnd& vehicle);
  void clear();
  /// Of a tether that has been observed. @param payout_rate  reported [m/s]; NaN: none is. Allocates.
  ForecastStart start(const CableSimulation& simulation, const VehicleEnd& vehicle, double payout_rate) const;
  bool isReady() const { return vessel_.isReady(); }
  bool isValid() const { return vessel_.isValid() && vehicle_.isValid(); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(vessel_, vehicle_);
  }

 private:
  EndMotionPredictor vessel_{true}, vehicle_{false};
};

}  // namespace tether_monitor::monitor
