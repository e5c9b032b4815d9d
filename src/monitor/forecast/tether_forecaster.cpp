#include "tether_monitor/monitor/forecast/tether_forecaster.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tether_monitor/monitor/estimate/estimate_summary.h"
#include "tether_monitor/monitor/forecast/member_course.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double STEP = MemberCourse::STEP;  // [s], and at most of the tether
constexpr double INTERVAL = 0.5;             // [s] between the times of a forecast
constexpr double BEGINNING = 2.0;  // [s] until a member has left the errors of the moment's motion behind
constexpr double LARGEST_LOST_SHARE = 0.25;  // of the members
constexpr double TOLERATED = 0.05;           // probability of over-tension
constexpr double SLOWEST_WAY = 0.1;          // speed below which a vessel has no way to go on [m/s]
constexpr int BISECTIONS = 4;

core::EndMotion endOf(const core::NodeCoords& q, const core::NodeCoords& v, const core::Vector3& origin)
{
  return {q.head<3>() + origin, v.head<3>()};
}

// The value nearest to `unsafe` that is safe; both ends are known to be what their names say.
template <class IsSafe>
double lastSafe(double safe, double unsafe, const IsSafe& isSafe)
{
  for (int k = 0; k < BISECTIONS; ++k)
  {
    const double middle = 0.5 * (safe + unsafe);
    (isSafe(middle) ? safe : unsafe) = middle;
  }
  return safe;
}

// (F7)
void scaleTension(double ratio, core::StationProfile& stations)
{
  for (double& tension : stations.tension)
    tension *= ratio;
  stations.ends.vessel *= ratio;
  stations.ends.vehicle *= ratio;
}

bool followsPlan(const ForecastStart& start, double horizon, const ForecastActions& actions)
{
  const bool is_steered = actions.vessel.velocity || actions.vessel.turn_rate;
  const bool has_course = !is_steered && (start.plan.velocity(start.t) || start.plan.velocity(start.t + horizon));
  return has_course || (start.payout_plan && !actions.payout_rate);
}
}  // namespace

TetherForecaster::TetherForecaster(const Config& config) : limits_(config), body_(config.vehicle_body)
{
  body_.attachment = config.vehicle.attachment;
}

bool TetherForecaster::simulateMember(const ForecastStart& start, const Extent& extent, int index,
                                      const ForecastActions& actions, const EndSamplers& samplers,
                                      core::AdaptiveStepper& stepper)
{
  const auto available = start.members.size();
  const auto wanted = static_cast<std::size_t>(extent.members);
  const auto from = static_cast<std::size_t>(index) < available && wanted < available ? index * available / wanted
                                                                                      : index % available;
  const ForecastMember& member = start.members[from];
  const core::CableModel& model = *start.model;
  core::CableState state = member.state;
  core::DeployedCable cable(model, state.deployment);
  core::Vector3 pull = core::endForces(cable, state).vehicle;
  MemberCourse course(start, actions, samplers, body_, member, pull, index);
  const int steps = static_cast<int>(std::lround(extent.horizon / STEP));
  const int first = static_cast<int>(std::lround(std::min(BEGINNING, 0.5 * extent.horizon) / STEP));
  for (int k = 1; k <= steps; ++k)
  {
    const double t = start.t + STEP * k;
    const core::BoundaryConditions ends = course.next(t, state, pull);
    if (isStopped() || !stepper.advance(model, ends, t, state).converged() || !state.allFinite())
      return false;
    cable.update(model, state.deployment);
    core::computeStations(cable, state, estimate_.stations);
    pull = estimate_.stations.ends.vehicle;
    scaleTension(member.tension_ratio, estimate_.stations);
    summarize(cable, estimate_);
    if (k < first)
      continue;
    // The first that counts stands for what was before.
    for (int at_step = k == first ? 1 : k; at_step <= k; ++at_step)
      traces_.add(index, STEP * at_step, estimate_, limits_);
    if (extent.isQuestion() && traces_.passesLimit(index))
      return true;
    if (estimate_.breaking_utilisation > 1.0)
    {
      // It parts; what would come after is no number.
      for (int later = k + 1; later <= steps; ++later)
        traces_.add(index, STEP * later, estimate_, limits_);
      break;
    }
  }
  std::vector<core::Vector3> stations = estimate_.stations.position;
  for (core::Vector3& station : stations)
    station += model.environment().origin();
  traces_.finish(index, std::move(stations));
  return true;
}

void TetherForecaster::simulate(const ForecastStart& start, const Extent& extent, const ForecastActions& actions)
{
  traces_.begin(extent.members, extent.horizon, INTERVAL);
  core::StepperOptions options = start.options;
  options.step = std::max(options.step, STEP);
  core::AdaptiveStepper stepper(*start.model, options);
  estimate_.stations = core::StationProfile(start.model->elements());
  const core::CableState& first = start.members.front().state;
  const core::Vector3& origin = start.model->environment().origin();
  MotionCommand command = actions.vessel;
  command.plan = &start.plan;
  EndSamplers samplers{{start.vessel, endOf(first.q.front(), first.v.front(), origin), STEP, command}, {}};
  if (start.vehicle)
    samplers.vehicle.emplace(*start.vehicle, endOf(first.q.back(), first.v.back(), origin), STEP);
  int passing = 0;
  for (int i = 0; i < extent.members && passing <= extent.tolerated; ++i)
  {
    if (!simulateMember(start, extent, i, actions, samplers, stepper))
      traces_.drop(i);
    passing += traces_.passesLimit(i);
  }
}

TetherForecast TetherForecaster::run(const ForecastStart& start, double horizon, int members,
                                     const ForecastActions& actions)
{
  TetherForecast forecast;
  forecast.t = start.t;
  forecast.horizon = horizon;
  forecast.from_plan = followsPlan(start, horizon, actions);
  simulate(start, {horizon, members, members}, actions);
  if (traces_.alive() >= std::max(2.0, (1.0 - LARGEST_LOST_SHARE) * members))
    traces_.summarize(forecast);
  return forecast;
}

bool TetherForecaster::isSafe(const ForecastStart& start, double horizon, int members,
                              const ForecastActions& actions)
{
  simulate(start, {horizon, members, static_cast<int>(TOLERATED * members)}, actions);
  return traces_.alive() >= (1.0 - LARGEST_LOST_SHARE) * members &&
         traces_.probabilityOfOverTension() <= TOLERATED;
}

double TetherForecaster::largestVesselSpeed(const ForecastStart& start, double horizon, int members, double high)
{
  core::Vector3 way(start.vessel.axis(0).mean()[1], start.vessel.axis(1).mean()[1], 0.0);
  if (way.norm() < SLOWEST_WAY)
    return TetherForecast::NONE;
  way.normalize();
  const auto isSafeAt = [&](double speed)
  {
    ForecastActions actions;
    actions.vessel.velocity = speed * way;
    return isSafe(start, horizon, members, actions);
  };
  if (!limits_.limit || !isSafeAt(0.0))
    return TetherForecast::NONE;
  if (isSafeAt(high))
    return high;
  return lastSafe(0.0, high, isSafeAt);
}

double TetherForecaster::leastPayoutRate(const ForecastStart& start, double horizon, int members, double low,
                                         double high)
{
  const auto isSafeAt = [&](double rate)
  {
    ForecastActions actions;
    actions.payout_rate = rate;
    return isSafe(start, horizon, members, actions);
  };
  if (!limits_.limit || !isSafeAt(high))
    return TetherForecast::NONE;
  if (isSafeAt(low))
    return low;
  return lastSafe(high, low, isSafeAt);
}

}  // namespace tether_monitor::monitor
