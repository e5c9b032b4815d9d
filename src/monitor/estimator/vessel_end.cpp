#include "tether_monitor/monitor/estimator/vessel_end.h"

#include "tether_monitor/monitor/estimator/filtered_vessel_end.h"
#include "tether_monitor/monitor/estimator/tracked_vessel_end.h"

namespace tether_monitor::monitor
{
std::unique_ptr<VesselEnd> makeVesselEnd(const Config& config)
{
  if (config.vehicle_mode == VehicleMode::OBSERVED)
    return std::make_unique<FilteredVesselEnd>(config);
  return std::make_unique<TrackedVesselEnd>(config);
}

}  // namespace tether_monitor::monitor
