#include "tether_monitor/monitor/estimator/tether_estimator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/monitor/estimate/estimate_summary.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double ABSURD = 10.0;           // breaking loads: no tether carries that, something told is wrong
constexpr double STRUMMING_PERIOD = 1.0;  // [s] of model time between looks at strumming

const Config& checked(const Config& config)
{
  core::throwIfInvalid("configuration of the monitor", validate(config));
  return config;
}

core::EndMotion shifted(const core::EndMotion& end, const core::Vector3& origin)
{
  return {end.position - origin, end.velocity};
}
}  // namespace

TetherEstimator::TetherEstimator(const Config& config)
  : config_(checked(config)),
    model_(makeModel(config)),
    stepper_(model_, config.solver),
    statics_(model_.nodes()),
    observer_(config_, model_.nodes()),
    alarms_(config),
    strumming_at_(-std::numeric_limits<double>::infinity()),
    obstacles_at_(std::numeric_limits<double>::quiet_NaN()),
    winch_capacity_(config.winch ? core::WinchDrum(*config.winch, config.tether.diameter).capacity()
                                 : std::numeric_limits<double>::infinity()),
    rejected_at_(-std::numeric_limits<double>::infinity())
{
  mesh_ = {config.elements, config.solver.step, TetherEstimate::NONE, !config.accuracy};
  estimate_.stations = core::StationProfile(config.elements);
  estimate_.contact.obstacles.resize(config.environment.obstacles.size());
}

void TetherEstimator::setCurrent(const core::CurrentProfile& current)
{
  model_.sea().setCurrent(current);
}

double TetherEstimator::thrustAge(double t) const
{
  return std::isnan(thrust_at_) ? 0.0 : std::max(t - thrust_at_, 0.0);
}

bool TetherEstimator::setDepth(double depth)
{
  core::Environment changed = model_.environment();
  if (!changed.seabed)
    return false;
  changed.seabed->depth = depth;
  if (!core::validate(changed).empty())
    return false;
  model_.sea().setDepth(depth);
  told_depth_ = depth;
  return true;
}

// Whether another deployed length can be meshed, with as many elements as there may be.
bool TetherEstimator::isPossible(double length) const
{
  return canMesh(config_, length, config_.accuracy ? core::MOST_ELEMENTS : config_.elements);
}

bool TetherEstimator::addPayout(double t, double length, double rate)
{
  const bool is_possible = (model_.canRepresentLength(length) || isPossible(length)) && length <= winch_capacity_;
  return is_possible && !(std::abs(rate) > PayoutBuffer::FASTEST) && payout_.add(t, length, rate);
}

void TetherEstimator::reset()
{
  vessel_.clear();
  vehicle_.clear();
  vessel_blender_.reset();
  vehicle_blender_.reset();
  vessel_filter_.clear();
  observer_.clear();
  payout_.clear();
  setThrust(TetherEstimate::NONE, core::Wrench());
  invalidate(Reason::NO_INPUT, estimate_);
  settled_ = announced_settling_ = started_ = false;
  rejected_at_ = -std::numeric_limits<double>::infinity();
  alarms_.resetTimers();
}

core::EndMotion TetherEstimator::targetOf(const MotionBuffer& track, const BodyConfig& body, double t,
                                          CorrectionBlender& blender) const
{
  const core::EndMotion now = track.at(t).attachmentPoint(body.attachment);
  return blender.blend(t, now, t - track.age(t), std::min(track.poseInterval(t), config_.pose_timeout));
}

EndTargets TetherEstimator::targetsAt(double t)
{
  EndTargets targets;
  if (isVehicleObserved())
  {
    aimAtObserved(t, targets);
  }
  else
  {
    targets.vessel = targetOf(vessel_, config_.vessel, t, vessel_blender_);
    targets.vessel_age = vessel_.age(t);
  }
  if (isVehicleFree())
    targets.vehicle_age = thrustAge(t);
  if (!isVehicleSimulated())
  {
    targets.vehicle = targetOf(vehicle_, config_.vehicle, t, vehicle_blender_);
    targets.vehicle_age = vehicle_.age(t);
  }
  if (payout_.hasReport())
  {
    targets.payout = payout_.blend(t);
    targets.payout_age = payout_.age(t);
  }
  return targets;
}

const TetherEstimate& TetherEstimator::refuse(double t, Reason reason)
{
  settled_ = false;
  estimate_.time = t;
  invalidate(reason, estimate_);
  alarms_changed_ = alarms_.update(estimate_);
  return estimate_;
}

void TetherEstimator::setVehicleAge(double age)
{
  estimate_.vehicle_age = age;
  estimate_.vehicle_overdue = isVehicleObserved() ? std::max(observer_.overdueTime(age), 0.0) : age;
}

void TetherEstimator::lookAtAges(double t)
{
  estimate_.vessel_age = isVehicleObserved() ? vessel_filter_.age(t) : vessel_.age(t);
  setVehicleAge(isVehicleObserved() ? observedAge(t) : isVehicleFree() ? thrustAge(t) : vehicle_.age(t));
  estimate_.payout_age = payout_.hasReport() ? payout_.age(t) : TetherEstimate::NONE;
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
    lookAtAges(t);
    return refuse(t, Reason::CLOCK_JUMP);
  }
  started_ = true;
  lookAtAges(t);
  if (!std::isfinite(estimate_.vessel_age) || !std::isfinite(estimate_.vehicle_age))
    return refuse(t, Reason::NO_INPUT);
  if (estimate_.vessel_age > config_.invalid_timeout)
    return refuse(t, Reason::VESSEL_STALE);
  if (estimate_.vehicle_age > config_.invalid_timeout && !isVehicleObserved())
    return refuse(t, Reason::VEHICLE_STALE);
  if (isVehicleObserved() && !settled_ && observer_.overdueTime(estimate_.vehicle_age) > config_.invalid_timeout)
    return refuse(t, Reason::VEHICLE_STALE);
  if (estimate_.payout_age > config_.invalid_timeout)
    return refuse(t, Reason::PAYOUT_STALE);
  if (settled_)
    return advance(t, targetsAt(t));
  if (!announced_settling_ || !canBegin(t))
  {
    announced_settling_ = true;
    retry_settling_at_ = t;
    return refuse(t, Reason::SETTLING);
  }
  if (t < retry_settling_at_)
    return refuse(t, estimate_.reason == Reason::OUT_OF_RANGE ? Reason::OUT_OF_RANGE : Reason::NOT_CONVERGED);
  return begin(t, targetsAt(t));
}

const TetherEstimate& TetherEstimator::begin(double t, const EndTargets& ends)
{
  announced_settling_ = started_ = true;
  estimate_.vessel_age = ends.vessel_age;
  setVehicleAge(ends.vehicle_age);
  estimate_.payout_age = ends.payout_age;
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
  setVehicleAge(ends.vehicle_age);
  estimate_.payout_age = ends.payout_age;
  if (t > state_.time)
  {
    const auto now = [&](std::size_t node) {
      return core::EndMotion{state_.q[node].head<3>(), state_.v[node].head<3>()};
    };
    core::BoundaryConditions paths;
    paths.vessel = core::EndTrajectory::between(state_.time, now(0), t, shifted(ends.vessel, origin_));
    if (!isVehicleSimulated())
      paths.vehicle =
          core::EndTrajectory::between(state_.time, now(state_.q.size() - 1), t, shifted(ends.vehicle, origin_));
    paths.vehicle_thrust = thrust_;
    if (ends.payout)
    {
      const double mean = (ends.payout->length - model_.length()) / (t - state_.time);
      if (std::abs(mean) > PayoutBuffer::FASTEST || std::abs(ends.payout->rate) > PayoutBuffer::FASTEST ||
          !model_.canRepresentLength(ends.payout->length))
      {
        announced_settling_ = true;
        retry_settling_at_ = t;
        noteRejectedInput(t);  // what follows is a steady state, not a motion
        return refuse(t, Reason::SETTLING);
      }
      paths.payout =
          core::PayoutTrajectory::between(state_.time, {model_.length(), payout_rate_, 0.0}, t, *ends.payout);
    }
    last_solve_ = step(paths, ends, t);
    payout_rate_ = ends.payout ? ends.payout->rate : 0.0;
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
  if (ends.vehicle_age > config_.pose_timeout && !isVehicleObserved())
    return Reason::VEHICLE_STALE;
  if (ends.payout_age > config_.pose_timeout)
    return Reason::PAYOUT_STALE;
  const Reason range = modelRange(model_, estimate_);
  if (range != Reason::NONE)
    return range;
  if (isVehicleObserved() && doubt(estimate_.time) != Reason::NONE)
    return doubt(estimate_.time);
  const double since_rejection = estimate_.time - rejected_at_;
  return since_rejection >= 0.0 && since_rejection <= config_.pose_timeout ? Reason::REJECTED_INPUT : Reason::NONE;
}

void TetherEstimator::lookAtStrumming()
{
  if (state_.time < strumming_at_ + STRUMMING_PERIOD && state_.time >= strumming_at_)
    return;
  strumming_at_ = state_.time;
  strumming_ = core::findLockIn(model_, state_, config_.drag_amplification);
}

const TetherEstimate& TetherEstimator::publish(const EndTargets& ends)
{
  estimate_.time = state_.time;
  core::computeStations(model_, state_, estimate_.stations);
  for (core::Vector3& position : estimate_.stations.position)
    position += origin_;
  estimate_.has_stations = true;
  estimate_.payout_rate = ends.payout ? payout_rate_ : TetherEstimate::NONE;
  summarize(model_, estimate_);
  describeContact(model_, state_, origin_, estimate_);
  if (isVehicleSimulated())
    describeVehicle(model_, state_, origin_, estimate_);
  if (isVehicleObserved())
    observer_.describe(estimate_);
  lookAtStrumming();
  if (!std::isfinite(estimate_.max_tension) ||
      !std::isfinite(estimate_.vessel_tension + estimate_.vehicle_tension))
    return refuse(state_.time, Reason::NOT_CONVERGED);
  if (estimate_.breaking_utilisation > ABSURD)
    return refuse(state_.time, Reason::OUT_OF_RANGE);
  const Reason lack = lackOf(state_.time);
  if (lack != Reason::NONE)
    return withhold(lack);
  estimate_.reason = degradation(ends);
  estimate_.status = estimate_.reason == Reason::NONE ? Status::OK : Status::DEGRADED;
  alarms_changed_ = alarms_.update(estimate_);
  return estimate_;
}

}  // namespace tether_monitor::monitor
