#include "tether_monitor/monitor/estimator/estimation_cycle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tether_monitor/monitor/estimate/estimate_summary.h"
#include "tether_monitor/monitor/estimator/estimate_writer.h"
#include "tether_monitor/monitor/estimator/steady_start.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double ABSURD = 10.0;         // breaking loads: no tether carries that, an input is wrong
constexpr double SETTLING_TIME = 60.0;  // [s] that a tether which was not at rest is given
constexpr int CATCH_UP_STEPS = 10;      // of a period in a tick: a start that took long is followed by more motion
constexpr double START_RETRY = 1.0;     // [s] between attempts to find a steady state
constexpr double LEAST_DEPLOYED = 0.1;  // [m]; less is none
constexpr double LONGEST_MEMORY = 60.0, SHORTEST_MEMORY = 1.0;  // of a tether for a blow [s]
}  // namespace

EstimationCycle::EstimationCycle(const Config& config)
  : config_(config),
    simulation_(config),
    vessel_(makeVesselEnd(config)),
    vehicle_(makeVehicleEnd(config)),
    payout_(config),
    watchdog_(config),
    vortex_shedding_(config.drag_amplification)
{
  estimate_.stations = core::StationProfile(config.elements);
  estimate_.contact.obstacles.resize(config.environment.obstacles.size());
}

void EstimationCycle::setEnvironment(const core::EnvironmentModel& environment)
{
  simulation_.model = simulation_.model.withEnvironment(environment);
}

bool EstimationCycle::setDepth(double depth)
{
  core::Environment changed = simulation_.model.environment().description();
  if (!changed.seabed)
    return false;
  changed.seabed->depth = depth;
  if (!core::validate(changed).empty())
    return false;
  setEnvironment(simulation_.model.environment().withDepth(depth));
  simulation_.reported_depth = depth;
  return true;
}

std::vector<std::string> EstimationCycle::setObstacles(double t, const std::vector<core::Obstacle>& obstacles)
{
  forgetStart();
  std::vector<std::string> faults = obstacles_.set(t, obstacles, isRunning(), simulation_, *vehicle_);
  if (faults.empty())
    estimate_.contact.obstacles.resize(obstacles.size());
  return faults;
}

bool EstimationCycle::addPayout(double t, double length, double rate)
{
  if (stowed_at_ && !(t > *stowed_at_))
    return false;
  if (length >= 0.0 && length < LEAST_DEPLOYED)
  {
    if (!payout_.addStowed(t, rate))
      return false;
    stowed_at_ = t;
    return true;
  }
  if (!payout_.add(t, length, rate, canDeploy(config_, simulation_.model, length)))
    return false;
  stowed_at_.reset();
  return true;
}

void EstimationCycle::reset()
{
  vessel_->clear();
  vehicle_->clear();
  payout_.clear();
  watchdog_.clear();
  findings_.clear();
  stowed_at_.reset();
  simulation_.state.deployment.parted_element.reset();
  invalidate(Reason::NO_INPUT, estimate_);
  phase_ = Phase::IDLE;
  forgetStart();
}

EndTargets EstimationCycle::targetsInMotion(double t)
{
  EndTargets targets;
  vessel_->aim(t, targets);
  vehicle_->aim(t, targets);
  payout_.aim(t, targets);
  return targets;
}

EndTargets EstimationCycle::targetsAt(double t)
{
  if (isRunning())
    return targetsInMotion(t);
  EndTargets targets;
  vessel_->aimAtStart(t, targets);
  vehicle_->aimAtStart(t, targets);
  payout_.aim(t, targets);
  return targets;
}

void EstimationCycle::updateAges(double t)
{
  EndTargets ages;
  ages.vessel_age = vessel_->age(t);
  ages.vehicle_age = vehicle_->age(t, isRunning());
  ages.payout_age = payout_.age(t);
  setAges(ages);
}

void EstimationCycle::setAges(const EndTargets& ends)
{
  estimate_.vessel_age = ends.vessel_age;
  estimate_.vehicle_age = ends.vehicle_age;
  estimate_.vehicle_overdue = vehicle_->overdue(ends.vehicle_age);
  estimate_.payout_age = ends.payout_age;
}

void EstimationCycle::announceStart(double t)
{
  phase_ = Phase::STARTING;
  retry_start_at_ = t;
  forgetStart();
}

void EstimationCycle::forgetStart()
{
  catches_up_ = false;
  start_worker_.discard();
}

const TetherEstimate& EstimationCycle::refuse(double t, Reason reason)
{
  if (isRunning())
    phase_ = Phase::STARTING;
  estimate_.time = t;
  invalidate(reason, estimate_);
  return estimate_;
}

const TetherEstimate& EstimationCycle::tick(double t)
{
  const double since_last = t - estimate_.time;
  const double longest_gap = std::max(config_.invalid_timeout, 3.0 / config_.rate);
  if (phase_ != Phase::IDLE && (since_last < 0.0 || since_last > longest_gap))
  {
    // Backwards, the clock has started again and the measurements belong to the old one.
    if (since_last < 0.0)
      reset();
    phase_ = Phase::WAITING;
    retry_start_at_ = t;
    forgetStart();
    updateAges(t);
    return refuse(t, Reason::CLOCK_JUMP);
  }
  if (phase_ == Phase::IDLE)
    phase_ = Phase::WAITING;
  updateAges(t);
  findings_.collect(*vessel_, *vehicle_, payout_, t);
  if (stowed_at_)
    return stowed(t);
  const ReasonSet missing = watchdog_.invalidReasons(estimate_, isRunning() && vehicle_->canCoast());
  if (!missing.isEmpty())
  {
    refuse(t, missing.gravest());
    estimate_.reasons = missing;
    return estimate_;
  }
  const bool vessel_leapt = vessel_->takeLeap(), vehicle_leapt = vehicle_->takeLeap();
  if ((vessel_leapt || vehicle_leapt) && phase_ != Phase::WAITING)
  {
    announceStart(t);
    return refuse(t, Reason::SETTLING);
  }
  if (isRunning())
    return advance(t, targetsAt(t));
  const bool is_under_way = catches_up_ || !start_worker_.isIdle();
  if (phase_ == Phase::WAITING || (!is_under_way && !canBegin(t)))
  {
    announceStart(t);
    return refuse(t, Reason::SETTLING);
  }
  if (t < retry_start_at_)
    return refuse(t, estimate_.reason == Reason::OUT_OF_RANGE ? Reason::OUT_OF_RANGE : Reason::NOT_CONVERGED);
  if (simulation_.state.deployment.parted_element)
    return refuse(t, Reason::NOT_CONVERGED);
  return starts_in_background_ ? startInBackground(t) : begin(t, targetsAt(t));
}

bool EstimationCycle::part(double s)
{
  if (!isRunning() || !(s > 0.0 && s < simulation_.length()))
    return false;
  simulation_.state.deployment.parted_element = simulation_.updatedCable().elementAt(s);
  simulation_.stepper.expectShock(simulation_.state);
  return true;
}

bool EstimationCycle::start(double t, const EndTargets& ends)
{
  phase_ = Phase::STARTING;
  if (simulation_.state.deployment.parted_element)
    return false;  // two pieces have no steady state to begin with
  return adopt(findSteadyStart(config_, simulation_, obstacles_.at(t, simulation_), *vehicle_, t, ends), t, ends,
               t);
}

// A tick launches the search, or waits for it, or follows the ends from the time of the start to its own.
const TetherEstimate& EstimationCycle::startInBackground(double t)
{
  start_worker_.collect();
  if (!catches_up_)
  {
    if (start_worker_.isIdle())
      start_worker_.search(config_, simulation_, obstacles_.at(t, simulation_), *vehicle_, t, targetsAt(t));
    else if (start_worker_.isReady() && !adoptFound(t))
      return refuse(t, Reason::NOT_CONVERGED);
    return refuse(t, Reason::SETTLING);
  }
  EndTargets ends;
  for (int k = 0; k < CATCH_UP_STEPS && simulation_.state.time < t; ++k)
  {
    const double next = std::min(t, simulation_.state.time + 1.0 / config_.rate);
    ends = targetsInMotion(next);
    simulation_.last_solve = step(next, ends);
    if (!simulation_.last_solve.converged())
    {
      announceStart(t);
      return refuse(t, Reason::NOT_CONVERGED);
    }
  }
  if (simulation_.state.time < t)
    return refuse(t, Reason::SETTLING);
  catches_up_ = false;
  phase_ = Phase::RUNNING;
  setAges(ends);
  return publish(ends);
}

// Currents and depths that came during the search are those of now.
bool EstimationCycle::adoptFound(double now)
{
  const core::EnvironmentModel latest = simulation_.model.environment();
  double t;
  EndTargets ends;
  SteadyStart found = start_worker_.take(t, ends);
  if (!adopt(std::move(found), t, ends, now))
    return false;
  setEnvironment(
      latest.withOrigin(simulation_.origin()).withObstacles(simulation_.model.environment().obstacles()));
  phase_ = Phase::STARTING;
  catches_up_ = true;
  return true;
}

bool EstimationCycle::adopt(SteadyStart found, double t, const EndTargets& ends, double now)
{
  simulation_.last_solve = found.simulation.last_solve;
  const bool is_at_rest = simulation_.last_solve.converged();
  if (!found.is_found)
  {
    retry_start_at_ = now + START_RETRY;
    return false;
  }
  settles_until_ = is_at_rest ? t : t + SETTLING_TIME;
  simulation_ = std::move(found.simulation);
  vehicle_->begin(found.vehicle, ends, simulation_);
  obstacles_.begin(t);
  payout_.reached(ends);
  vortex_shedding_.begin(found.vortex_shedding);
  estimate_.stations = core::StationProfile(simulation_.mesh.elements);
  phase_ = Phase::RUNNING;
  return true;
}

const TetherEstimate& EstimationCycle::begin(double t, const EndTargets& ends)
{
  setAges(ends);
  return start(t, ends) ? publish(ends) : refuse(t, Reason::NOT_CONVERGED);
}

core::SolveReport EstimationCycle::step(double t, const EndTargets& ends)
{
  const core::CableState& state = simulation_.state;
  core::BoundaryConditions paths;
  paths.vessel = core::EndTrajectory::between(state.time, {state.q[0].head<3>(), state.v[0].head<3>()}, t,
                                              {ends.vessel.position - simulation_.origin(), ends.vessel.velocity});
  paths.clamps = ends.clamps;
  paths.payout = payout_.trajectory(ends, t, simulation_);
  const core::SolveReport report = vehicle_->advance(paths, ends, t, simulation_);
  payout_.reached(ends);
  simulation_.count.steps += report.steps;
  simulation_.count.rejected += report.rejected;
  simulation_.count.iterations += report.iterations;
  return report;
}

const TetherEstimate& EstimationCycle::advance(double t, const EndTargets& ends)
{
  if (phase_ == Phase::STARTING)
    return begin(t, ends);
  if (!isRunning())
  {
    announceStart(t);
    return refuse(t, Reason::SETTLING);
  }
  setAges(ends);
  if (t > simulation_.state.time)
  {
    if (payout_.isLeap(ends, t, simulation_))
    {
      announceStart(t);
      watchdog_.noteRejectedInput(t);  // what follows is a steady state, not a motion
      return refuse(t, Reason::SETTLING);
    }
    simulation_.last_solve = step(t, ends);
    if (!simulation_.last_solve.converged())
    {
      announceStart(t);
      return refuse(t, Reason::NOT_CONVERGED);
    }
  }
  return publish(ends);
}

// Nothing is out: no numbers, and no alarm. As an input that has stopped, an old report is none.
const TetherEstimate& EstimationCycle::stowed(double t)
{
  estimate_.payout_age = t - *stowed_at_;
  phase_ = Phase::WAITING;
  forgetStart();
  if (estimate_.payout_age > config_.invalid_timeout)
    return refuse(t, Reason::PAYOUT_STALE);
  refuse(t, Reason::NONE);
  estimate_.status = Status::STOWED;
  estimate_.is_stowed = true;
  return estimate_;
}

// The way of a wave to the other end and back.
double EstimationCycle::memory() const
{
  const double frequency = vortexShedding().fundamental_frequency;
  return frequency > 0.0 ? std::clamp(1.0 / frequency, SHORTEST_MEMORY, LONGEST_MEMORY) : LONGEST_MEMORY;
}

ReasonSet EstimationCycle::degradedReasons() const
{
  ReasonSet reasons = watchdog_.lateReasons(estimate_, vehicle_->canCoast());
  reasons.add(modelRange(simulation_.cable, estimate_));
  reasons.add(vehicle_->degradedReason(estimate_));
  if (estimate_.time < settles_until_)
    reasons.add(Reason::SETTLING);
  if (findings_.record().holdsAny(estimate_.time, memory()))
    reasons.add(Reason::IMPLAUSIBLE);
  if (watchdog_.hasRejectedInput(estimate_.time))
    reasons.add(Reason::REJECTED_INPUT);
  return reasons;
}

const TetherEstimate& EstimationCycle::publish(const EndTargets& ends)
{
  const double time = simulation_.state.time;
  estimate_.payout_rate = ends.payout ? payout_.rate() : TetherEstimate::NONE;
  writeEstimate(simulation_, *vehicle_, estimate_);
  vortex_shedding_.update(simulation_);
  if (!std::isfinite(estimate_.max_tension) ||
      !std::isfinite(estimate_.vessel_tension + estimate_.vehicle_tension))
    return refuse(time, Reason::NOT_CONVERGED);
  if (estimate_.breaking_utilisation > ABSURD)
    return refuse(time, Reason::OUT_OF_RANGE);
  const Reason worthless = vehicle_->invalidReason(estimate_, ends);
  if (worthless != Reason::NONE)
  {
    invalidate(worthless, estimate_);
    return estimate_;
  }
  findings_.checkWorld(simulation_.model.environment(), estimate_);
  estimate_.is_stowed = false;
  estimate_.reasons = degradedReasons();
  estimate_.reason = estimate_.reasons.gravest();
  estimate_.status = estimate_.reason == Reason::NONE ? Status::OK : Status::DEGRADED;
  return estimate_;
}

}  // namespace tether_monitor::monitor
