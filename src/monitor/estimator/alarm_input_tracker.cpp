#include "tether_monitor/monitor/estimator/alarm_input_tracker.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/alarms/alarm_quantities.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double LEAST_DEPTH = 0.5;       // of a vehicle below the vessel end that has a scope [m]
constexpr double FINEST_SHARE = 0.05;     // of a piece between two stations, in the search for the nearest point
constexpr double LONGEST_INTERVAL = 3.0;  // cycles

bool isWatched(const Config& config, const std::string& name)
{
  const AlarmConfig alarm = alarmConfig(config, alarmQuantity(name));
  return alarm.limit || alarm.warning;
}

double horizontal(const core::Vector3& way)
{
  return std::hypot(way.x(), way.y());
}

core::Vector3 placeAt(const core::StationProfile& at, double s)
{
  const auto next = std::upper_bound(at.s.begin(), at.s.end(), s);
  if (next == at.s.begin())
    return at.position.front();
  if (next == at.s.end())
    return at.position.back();
  const std::size_t k = next - at.s.begin();
  const double share = (s - at.s[k - 1]) / (at.s[k] - at.s[k - 1]);
  return (1.0 - share) * at.position[k - 1] + share * at.position[k];
}
}  // namespace

AlarmInputTracker::AlarmInputTracker(const Config& config)
  : longest_interval_(LONGEST_INTERVAL / config.rate),
    wants_clearance_(isWatched(config, "obstacle_clearance")),
    contact_radius_(0.5 * config.tether.contact_diameter.value_or(config.tether.diameter)),
    load_cell_(config),
    locator_(config)
{
}

void AlarmInputTracker::clear()
{
  load_cell_.clear();
  locator_.clear();
  snag_ = SnagPlace();
  last_time_ = last_tension_ = AlarmInputs::NONE;
  inputs_ = AlarmInputs();
}

void AlarmInputTracker::describeTension(const TetherEstimate& e)
{
  const double dt = e.time - last_time_;
  if (dt > 0.0 && dt <= longest_interval_)
    inputs_.tension_rate = (e.max_tension - last_tension_) / dt;
  last_time_ = e.time;
  last_tension_ = e.max_tension;
}

void AlarmInputTracker::describeGeometry(const TetherEstimate& e)
{
  const core::StationProfile& at = e.stations;
  const core::Vector3 way = at.position.back() - at.position.front();
  inputs_.lay_back = horizontal(way);
  if (-way.z() > LEAST_DEPTH)
    inputs_.scope = e.length / -way.z();
  if (!std::isnan(e.touchdown_s))
    inputs_.touchdown_distance = horizontal(placeAt(at, e.touchdown_s) - at.position.front());
}

void AlarmInputTracker::describeContact(const TetherEstimate& e, const CableSimulation& simulation)
{
  if (!e.contact.obstacles.empty())
    inputs_.obstacle_force = 0.0;
  for (const core::ContactSummary::ObstacleContact& touch : e.contact.obstacles)
    if (touch.total > inputs_.obstacle_force)
    {
      inputs_.obstacle_force = touch.total;
      inputs_.obstacle_force_s = touch.s;
    }
  if (wants_clearance_)
    findClearance(e, simulation);
}

// A distance changes by no more than the step along the tether: so far the next point may be.
void AlarmInputTracker::findClearance(const TetherEstimate& e, const CableSimulation& simulation)
{
  const core::StationProfile& at = e.stations;
  const std::vector<core::Obstacle>& obstacles = simulation.model.environment().obstacles();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < obstacles.size(); ++k)
  {
    const core::Vector3 centre = simulation.state.obstacles[k].position + simulation.origin();
    const double radius = core::enclosingRadius(obstacles[k]);
    for (std::size_t i = 1; i < at.s.size(); ++i)
    {
      const core::Vector3 begin = at.position[i - 1] - centre, piece = at.position[i] - at.position[i - 1];
      const double length = piece.norm();
      if (std::min(begin.norm(), (begin + piece).norm()) - length - radius > least)
        continue;
      for (double x = 0.0; x <= length;)
      {
        const double share = length > 0.0 ? x / length : 0.0;
        const double distance = core::signedDistance(obstacles[k], begin + share * piece).distance;
        if (distance < least)
        {
          least = distance;
          inputs_.clearance_s = at.s[i - 1] + share * (at.s[i] - at.s[i - 1]);
        }
        x += std::max({distance - least, FINEST_SHARE * length, 1e-3});
      }
    }
  }
  if (std::isfinite(least))
    inputs_.clearance = least - contact_radius_;
}

void AlarmInputTracker::countTurns(const TetherEstimate& e, const VesselEnd& vessel, const VehicleEnd& vehicle)
{
  const bool is_simulated = e.has_vehicle;
  if (vessel.track().hasPose() && (is_simulated || vehicle.track().hasPose()))
    turns_.update(vessel.track().lastOrientation(),
                  is_simulated ? e.vehicle.orientation : vehicle.track().lastOrientation());
  inputs_.turns = turns_.turns();
}

void AlarmInputTracker::checkLoadCell(const TetherEstimate& e, CableSimulation& simulation,
                                      const VehicleEnd& vehicle)
{
  const TetherEnsemble* ensemble = vehicle.ensemble();
  load_cell_.update(e, simulation, ensemble ? &ensemble->filter().tensionResidual() : nullptr);
  inputs_.mismatch = load_cell_.mismatch();
  if (!e.has_stations)
    return;
  if (!std::isnan(inputs_.mismatch) && load_cell_.isQuiet())
    locator_.remember(e);
  snag_ = SnagPlace();
  if (load_cell_.cause() != MismatchCause::SNAG)
    return;
  const TensionResidual& residual = load_cell_.residual();
  snag_ = locator_.find(e.stations.position.front(), simulation.state.v.front().head<3>(), residual.measured,
                        residual.stddev);
  inputs_.mismatch_s = snag_.s;
}

const AlarmInputs& AlarmInputTracker::update(const TetherEstimate& e, CableSimulation& simulation,
                                             const VesselEnd& vessel, const VehicleEnd& vehicle,
                                             const core::VortexShedding& vortex_shedding)
{
  inputs_ = AlarmInputs();
  countTurns(e, vessel, vehicle);
  checkLoadCell(e, simulation, vehicle);
  inputs_.resonance = report_.resonance;
  inputs_.missed_cycles = report_.missed_cycles;
  if (!e.has_stations)
  {
    last_time_ = AlarmInputs::NONE;
    return inputs_;
  }
  inputs_.forecast_probability = report_.forecast_probability;
  describeTension(e);
  describeGeometry(e);
  describeContact(e, simulation);
  inputs_.lock_in = vortex_shedding.length / e.length;
  return inputs_;
}

}  // namespace tether_monitor::monitor
