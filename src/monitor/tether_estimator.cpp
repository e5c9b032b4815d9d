#include "tether_monitor/monitor/tether_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/bounds.h"
#include "tether_monitor/monitor/assessment.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double SETTLING_RETRY = 1.0;       // [s] between attempts to find a steady state
constexpr double LENGTH_TOLERANCE = 1.0e-3;  // relative change of the deployed length that makes the tether settle

const Config& checked(const Config& config)
{
  std::vector<std::string> faults = problems(config);
  if (config.vehicle_mode == VehicleMode::FREE)
    faults.push_back("vehicle.mode = free (must be tracked here; a free vehicle is for tether_steady so far)");
  core::throwIfAny("configuration of the monitor", faults);
  return config;
}

void shift(double by, core::CableFittings& fittings)
{
  for (core::CableSection& section : fittings.sections)
  {
    section.from = section.from == 0.0 ? 0.0 : section.from + by;
    section.to += by;
  }
  for (core::Attachment& attachment : fittings.attachments)
    attachment.s += by;
}

core::EndPoint shifted(const core::EndPoint& end, const core::Vector3& origin)
{
  return {end.position - origin, end.velocity};
}
}  // namespace

TetherEstimator::TetherEstimator(const Config& config)
  : config_(checked(config)),
    model_(config.tether, config.elements, config.environment, config.fittings),
    stepper_(model_, config.solver),
    statics_(model_.nodes()),
    alarms_(config),
    rejected_at_(-std::numeric_limits<double>::infinity())
{
  estimate_.stations = core::StationField(config.elements);
}

void TetherEstimator::setCurrent(const core::CurrentProfile& current)
{
  model_.sea().setCurrent(current);
}

bool TetherEstimator::setPayout(double length, double rate)
{
  if (!std::isfinite(length) || length <= 0.0 || std::isinf(rate))
    return false;
  estimate_.payout_rate = rate;
  if (std::abs(length - model_.length()) <= LENGTH_TOLERANCE * model_.length())
    return true;
  // What is fixed to the tether keeps its distance from the vehicle end, as the tether pays out at the vessel.
  core::CableFittings fittings = config_.fittings;
  shift(length - config_.tether.length, fittings);
  if (!core::problems(fittings, length).empty() ||
      !core::elementCountProblems(config_.elements, length, fittings).empty())
    return false;
  config_.fittings = fittings;
  const core::CurrentProfile current = model_.environment().current;
  config_.tether.length = length;
  model_ = core::CableModel(config_.tether, config_.elements, config_.environment, config_.fittings);
  model_.sea().setCurrent(current);
  settled_ = announced_settling_ = false;
  return true;
}

void TetherEstimator::reset()
{
  vessel_.clear();
  vehicle_.clear();
  vessel_follower_.reset();
  vehicle_follower_.reset();
  settled_ = announced_settling_ = started_ = false;
  rejected_at_ = -std::numeric_limits<double>::infinity();
  alarms_.restartClocks();
}

core::EndPoint TetherEstimator::targetOf(const BodyTrack& track, const BodyConfig& body, double t,
                                         EndFollower& follower) const
{
  const core::EndPoint now = track.at(t).attachmentPoint(body.attachment);
  return follower.follow(t, now, t - track.age(t), std::min(track.poseInterval(t), config_.pose_timeout));
}

EndTargets TetherEstimator::targetsAt(double t)
{
  return {targetOf(vessel_, config_.vessel, t, vessel_follower_),
          targetOf(vehicle_, config_.vehicle, t, vehicle_follower_), vessel_.age(t), vehicle_.age(t)};
}

const TetherEstimate& TetherEstimator::refuse(double t, Reason reason)
{
  settled_ = false;
  estimate_.time = t;
  invalidate(reason, estimate_);
  alarms_changed_ = alarms_.update(estimate_);
  return estimate_;
}

const TetherEstimate& TetherEstimator::tick(double t)
{
  const double since_last = t - estimate_.time;
  const double longest_gap = std::max(config_.invalid_timeout, 3.0 / config_.rate);
  if (started_ && (since_last < 0.0 || since_last > longest_gap))
  {
    // Backwards, a new run of the clock has begun and the measurements belong to the old one.
    if (since_last < 0.0)
      reset();
    started_ = true;
    settled_ = announced_settling_ = false;
    retry_settling_at_ = t;
    estimate_.vessel_age = vessel_.age(t);
    estimate_.vehicle_age = vehicle_.age(t);
    return refuse(t, Reason::CLOCK_JUMP);
  }
  started_ = true;
  estimate_.vessel_age = vessel_.age(t);
  estimate_.vehicle_age = vehicle_.age(t);
  if (!std::isfinite(estimate_.vessel_age) || !std::isfinite(estimate_.vehicle_age))
    return refuse(t, Reason::NO_INPUT);
  if (estimate_.vessel_age > config_.invalid_timeout)
    return refuse(t, Reason::VESSEL_STALE);
  if (estimate_.vehicle_age > config_.invalid_timeout)
    return refuse(t, Reason::VEHICLE_STALE);
  if (settled_)
    return advance(t, targetsAt(t));
  if (!announced_settling_)
  {
    announced_settling_ = true;
    retry_settling_at_ = t;
    return refuse(t, Reason::SETTLING);
  }
  if (t < retry_settling_at_)
    return refuse(t, Reason::NOT_CONVERGED);
  return begin(t, targetsAt(t));
}

bool TetherEstimator::settle(double t, const EndTargets& ends)
{
  origin_ = {ends.vessel.position.x(), ends.vessel.position.y(), 0.0};
  const core::SteadyEnds steady{ends.vessel.position - origin_, ends.vehicle.position - origin_,
                                ends.vessel.velocity};
  core::NodeField shape;
  last_solve_ = statics_.solve(model_, steady, shape);
  settled_ = last_solve_.converged();
  if (settled_)
    state_ = core::CableState(t, shape, ends.vessel.velocity);
  else
    retry_settling_at_ = t + SETTLING_RETRY;
  return settled_;
}

const TetherEstimate& TetherEstimator::begin(double t, const EndTargets& ends)
{
  announced_settling_ = started_ = true;
  estimate_.vessel_age = ends.vessel_age;
  estimate_.vehicle_age = ends.vehicle_age;
  if (!settle(t, ends))
    return refuse(t, Reason::NOT_CONVERGED);
  return publish(ends);
}

const TetherEstimate& TetherEstimator::advance(double t, const EndTargets& ends)
{
  if (!settled_ && !announced_settling_)
  {
    announced_settling_ = true;
    return refuse(t, Reason::SETTLING);
  }
  if (!settled_)
    return begin(t, ends);
  estimate_.vessel_age = ends.vessel_age;
  estimate_.vehicle_age = ends.vehicle_age;
  if (t > state_.time)
  {
    const auto now = [&](std::size_t node) {
      return core::EndPoint{state_.q[node].head<3>(), state_.v[node].head<3>()};
    };
    const core::EndPaths paths{
        core::EndPath::between(state_.time, now(0), t, shifted(ends.vessel, origin_)),
        core::EndPath::between(state_.time, now(state_.q.size() - 1), t, shifted(ends.vehicle, origin_))};
    last_solve_ = stepper_.advance(model_, paths, t, state_);
    count_.steps += last_solve_.steps;
    count_.rejected += last_solve_.rejected;
    count_.iterations += last_solve_.iterations;
    if (!last_solve_.converged())
    {
      retry_settling_at_ = t;
      return refuse(t, Reason::NOT_CONVERGED);
    }
  }
  return publish(ends);
}

Reason TetherEstimator::degradation(const EndTargets& ends) const
{
  if (ends.vessel_age > config_.pose_timeout)
    return Reason::VESSEL_STALE;
  if (ends.vehicle_age > config_.pose_timeout)
    return Reason::VEHICLE_STALE;
  const Reason range = modelRange(estimate_);
  if (range != Reason::NONE)
    return range;
  const double since_rejection = estimate_.time - rejected_at_;
  return since_rejection >= 0.0 && since_rejection <= config_.pose_timeout ? Reason::REJECTED_INPUT : Reason::NONE;
}

const TetherEstimate& TetherEstimator::publish(const EndTargets& ends)
{
  estimate_.time = state_.time;
  core::computeStations(model_, state_, estimate_.stations);
  for (core::Vector3& position : estimate_.stations.position)
    position += origin_;
  estimate_.has_stations = true;
  summarise(model_, estimate_);
  if (!std::isfinite(estimate_.max_tension) ||
      !std::isfinite(estimate_.vessel_tension + estimate_.vehicle_tension))
    return refuse(state_.time, Reason::NOT_CONVERGED);
  estimate_.reason = degradation(ends);
  estimate_.status = estimate_.reason == Reason::NONE ? Status::OK : Status::DEGRADED;
  alarms_changed_ = alarms_.update(estimate_);
  return estimate_;
}

}  // namespace tether_monitor::monitor
