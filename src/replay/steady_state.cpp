#include "tether_monitor/replay/steady_state.h"

#include "tether_monitor/core/bounds.h"
#include "tether_monitor/core/statics.h"
#include "tether_monitor/monitor/assessment.h"

namespace tether_monitor::replay
{
SteadyState findSteadyState(const monitor::Config& config, const core::Vector3& vessel,
                            const core::Vector3& vehicle, const core::Vector3& velocity)
{
  core::throwIfAny("configuration", problems(config));
  core::CableModel model(config.tether, config.elements, config.environment, config.fittings);
  const core::SteadyEnds ends{vessel + config.vessel.attachment, vehicle + config.vehicle.attachment, velocity};
  if (config.vehicle_mode == monitor::VehicleMode::FREE)
    model.setBodies({std::nullopt, config.vehicle_body});

  SteadyState result;
  core::NodeField shape;
  core::Statics statics(model.nodes());
  result.report = statics.solve(model, ends, shape);
  monitor::TetherEstimate& e = result.estimate;
  if (!result.report.converged())
  {
    monitor::invalidate(monitor::Reason::NOT_CONVERGED, e);
    return result;
  }
  e.stations = core::StationField(config.elements);
  core::computeStations(model, core::CableState(0.0, shape, velocity), e.stations);
  e.has_stations = true;
  monitor::summarise(model, e);
  e.reason = monitor::modelRange(e);
  e.status = e.reason == monitor::Reason::NONE ? monitor::Status::OK : monitor::Status::DEGRADED;
  return result;
}

}  // namespace tether_monitor::replay
