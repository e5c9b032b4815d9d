#include "tether_monitor/replay/steady_state_run.h"

#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::replay
{
SteadyState findSteadyState(const monitor::Config& config, const core::Vector3& vessel,
                            const core::Vector3& vehicle, const core::Vector3& velocity, int modes)
{
  monitor::Config calm = config;
  calm.environment.waves = core::SeaState();
  if (calm.vehicle_mode == monitor::VehicleMode::OBSERVED)
    calm.vehicle_mode = monitor::VehicleMode::TRACKED;
  monitor::TetherEstimator estimator(calm);
  monitor::EndTargets ends;
  core::Vector3 level = velocity;
  level.z() = 0.0;  // heave is no steady motion
  ends.vessel = {vessel + config.vessel.attachment, level};
  ends.vehicle = {vehicle + config.vehicle.attachment, level};

  ends.clamps.vessel = monitor::clampDirection(config.vessel, Eigen::Quaterniond::Identity());
  ends.clamps.vehicle = -monitor::clampDirection(config.vehicle, Eigen::Quaterniond::Identity());

  SteadyState result;
  result.estimate = estimator.begin(0.0, ends);
  result.report = estimator.simulation().last_solve;
  if (!result.estimate.has_stations)
    return result;
  result.vortex_shedding = estimator.vortexShedding();
  if (modes > 0)
    result.modes = core::naturalModes(estimator.simulation().model, estimator.simulation().state, modes);
  for (int i = 0; i < estimator.simulation().cable.nodes(); ++i)
    result.node_s.push_back(estimator.simulation().cable.arcLength(i));
  return result;
}

}  // namespace tether_monitor::replay
