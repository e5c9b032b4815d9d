#include "tether_monitor/monitor/vehicle/vehicle_observer.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/monitor/vehicle/vehicle_initializer.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr std::size_t LEAST_STEPS = 128, MOST_STEPS = 8192;
constexpr double LONGEST_STEP = 0.1;              // [s] between corrections
constexpr double RELINEARIZATION_INTERVAL = 5.0;  // [s] between linearisations of the tether
constexpr double ATTITUDE_RATE = 1.0;             // [rad/s] with which the vehicle turns to its measured attitude
constexpr double DEFAULT_DISTURBANCE_ACCELERATION = 0.16;  // unmodelled disturbance, over the mass [m/s^2]
constexpr double FORCE_RANDOM_WALK =
    0.003;  // of the disturbance in a second, over its standard deviation [1/sqrt(s)]
constexpr double DRAG_RANDOM_WALK = 0.003;       // likewise of the drag
constexpr double INITIAL_VELOCITY_STDDEV = 0.2;  // standard deviation of the vehicle's velocity at the start [m/s]
constexpr double EXPECTED_COST = 3.0;            // cost of a start that chance explains [-]
constexpr double FIRST_WAIT = 5.0;               // [s] for the first three positions
constexpr double FIRST_DRIFT = 0.3;              // speed by which the vehicle may part from the vessel then [m/s]
constexpr double FRESH_INTERVALS = 4.0;  // so many usual intervals a position is fresh enough to begin with
constexpr int FIRST_FIXES = 3, MEDIAN_OF = 5;
constexpr double STRETCH_SHARE = 0.1, STRETCH_MOST = 3.0, STRETCH_LIMIT = 0.75;
constexpr double MODEL_ERROR_STDDEV = 0.002;  // of a tension, relative: mesh, step, rounding of motions [-]

ProcessNoiseModel disturbanceModel(const NavigationConfig& navigation, const core::RigidBody& body)
{
  ProcessNoiseModel model;
  model.force = navigation.force_stddev.value_or(DEFAULT_DISTURBANCE_ACCELERATION * body.mass);
  model.force_random_walk = FORCE_RANDOM_WALK * model.force;
  model.drag = navigation.drag_stddev;
  model.gains = navigation.gains;
  model.drag_random_walk = DRAG_RANDOM_WALK * model.drag;
  return model;
}

double rootMeanVariance(const core::Matrix3& covariance)
{
  return std::sqrt(covariance.diagonal().cwiseMax(0.0).sum() / 3.0);
}

double median(std::array<double, MEDIAN_OF>& x, int n)
{
  std::sort(x.begin(), x.begin() + n);
  return 0.5 * (x[(n - 1) / 2] + x[n / 2]);
}
}  // namespace

// Steps to remember: as far back as a measurement may have to be put.
std::size_t VehicleObserver::stepsFor(const Config& config)
{
  const double rate = std::max({config.rate, 1.0 / config.solver.step, 1.0 / LONGEST_STEP});
  const double steps = 1.5 * rate * (config.navigation.latency + OUT_OF_ORDER);
  return static_cast<std::size_t>(
      std::clamp(steps, static_cast<double>(LEAST_STEPS), static_cast<double>(MOST_STEPS)));
}

VehicleObserver::VehicleObserver(const Config& config, int nodes)
  : navigation_(config.navigation),
    body_(config.vehicle_body),
    invalid_timeout_(config.invalid_timeout),
    steps_capacity_(stepsFor(config)),
    solver_(nodes),
    initialized_at_(-std::numeric_limits<double>::infinity()),
    steps_(steps_capacity_),
    snapshots_(SNAPSHOTS),
    timing_(config.navigation.latency)
{
  body_.attachment = config.vehicle.attachment;
}

double VehicleObserver::earliestTime() const
{
  return snapshots_.empty() ? -std::numeric_limits<double>::infinity() : snapshots_.front().state.time;
}

Rejection VehicleObserver::check(const VehicleMeasurement& fix) const
{
  return fix.t <= initialized_at_ ? Rejection::NONE : history_.check(fix, earliestTime());
}

Rejection VehicleObserver::add(const VehicleMeasurement& fix)
{
  if (fix.t <= initialized_at_)
    return Rejection::NONE;
  const Rejection rejection = history_.add(fix, earliestTime());
  while (snapshots_.size() > 1 && snapshots_.front().state.time < history_.droppedUntil())
    snapshots_.popFront();
  if (rejection == Rejection::NONE && fix.measuresPosition(0))
    timing_.add(fix.t, steps_.empty() ? std::numeric_limits<double>::quiet_NaN() : steps_.back().to);
  return rejection;
}

void VehicleObserver::clear()
{
  history_.clear();
  filter_state_ = FilterState();
  steps_.clear();
  snapshots_.clear();
  attitude_.reset();
  initialized_at_ = -std::numeric_limits<double>::infinity();
  timing_.clear();
}

double VehicleObserver::oldestUsableTime(double t) const
{
  return t - navigation_.latency - std::max(invalid_timeout_, FRESH_INTERVALS * timing_.interval());
}

std::optional<MeasuredVector> VehicleObserver::initialPositionEstimate(double t,
                                                                       const core::Vector3& velocity) const
{
  const auto& fixes = history_.fixes();
  core::Vector3 place, stddev = core::Vector3::Zero();
  for (int axis = 0; axis < 3; ++axis)
  {
    std::array<double, MEDIAN_OF> last{};
    int n = 0;
    for (auto fix = fixes.rbegin(); fix != fixes.rend() && n < MEDIAN_OF; ++fix)
      if (fix->measuresPosition(axis) && (n == 0 || fix->t > oldestUsableTime(t)))
      {
        last[n++] = fix->value.value()[axis] + velocity[axis] * (t - fix->t);
        stddev[axis] = std::max(stddev[axis], std::hypot(fix->value.stddev(axis), FIRST_DRIFT * (t - fix->t)));
      }
    if (n == 0)
      return std::nullopt;
    place[axis] = median(last, n);
  }
  return MeasuredVector::withStddev(place, stddev);
}

bool VehicleObserver::isReady(double t) const
{
  const auto& fixes = history_.fixes();
  for (int axis = 0; axis < 3; ++axis)
  {
    int n = 0;
    double first = t;
    for (const VehicleMeasurement& fix : fixes)
      if (fix.measuresPosition(axis) && fix.t > oldestUsableTime(t))
      {
        first = n++ == 0 ? fix.t : first;
      }
    if (n == 0 || (n < FIRST_FIXES && t - first <= FIRST_WAIT + navigation_.latency))
      return false;
  }
  return true;
}

core::SolveReport VehicleObserver::initialize(core::SteadyStateSolver& statics, const core::CableModel& model,
                                              const core::SteadyEnds& ends, const core::Matrix3& covariance,
                                              const core::Vector3& velocity_stddev, const core::Vector3& thrust,
                                              VehicleInitialization& start) const
{
  const ProcessNoiseModel disturbance = disturbanceModel(navigation_, body_);
  InitializationInputs inputs{ends, covariance, thrust, disturbance.force * disturbance.axisRatios()};
  VehicleInitialization found;
  double scale = 1.0;
  core::SolveReport report = findVehicleInitialization(statics, model, inputs, found);
  if (report.converged() && found.cost > EXPECTED_COST)
  {
    // More than chance explains: the forces here are larger than usual.
    scale = std::sqrt(found.cost / EXPECTED_COST);
    inputs.force_stddev *= scale;
    report = findVehicleInitialization(statics, model, inputs, found);
  }
  if (!report.converged())
    return report;
  const double stddev = std::sqrt(covariance.trace() / 3.0);
  const bool is_too_far = (ends.vehicle - ends.vessel).norm() > model.length(ends.deployment) + 3.0 * stddev;
  found.force_scale = scale;
  found.chord_excess = is_too_far ? 1.0 : 0.0;
  found.force_covariance = forceCovarianceFromVelocity(statics, model, ends, velocity_stddev, found);
  start = found;
  return report;
}

core::CableModel VehicleObserver::modelWithInitialForces(const core::CableModel& model,
                                                         const VehicleInitialization& start,
                                                         const core::Vector3& thrust) const
{
  core::RigidBody body = body_;
  body.force += start.force + thrust;
  return model.withBodies({std::nullopt, body});
}

void VehicleObserver::prepare(const core::CableModel& model)
{
  solver_ = core::EndDynamicStiffnessSolver(model.nodes());
  cable_.emplace(model);
  steps_.clear();
  snapshots_.clear();
}

void VehicleObserver::begin(const core::CableModel& model, const VehicleInitialization& start, double measured_at,
                            core::CableState& state)
{
  prepare(model);
  initialized_at_ = state.time;
  origin_ = model.environment().origin();
  if (attitude_)
    state.vehicle.orientation = *attitude_;
  TetherLinearization stiffness;
  stiffness.mass = (body_.mass + body_.added_mass.mean()) * core::Matrix3::Identity();
  cable_->update(model, state.deployment);
  linearizeTether(solver_, *cable_, state, 1.0, stiffness);
  ProcessNoiseModel disturbance = disturbanceModel(navigation_, body_);
  disturbance.force *= start.force_scale;
  disturbance.force_random_walk *= start.force_scale;
  filter_state_.filter.start(disturbance, start.position_covariance, INITIAL_VELOCITY_STDDEV, start.force,
                             start.force_covariance, dragOn(model, state), stiffness);
  filter_state_.gate.start(state.time, measured_at);
  filter_state_.chord_excess = start.chord_excess;
  filter_state_.relinearize_at = state.time + RELINEARIZATION_INTERVAL;
  history_.discardBefore(state.time);
  history_.markProcessed();
  for (StateSnapshot& slot : snapshots_.storage())
    slot.state = state;
  save(state);
}

core::Vector3 VehicleObserver::dragOn(const core::CableModel& model, const core::CableState& state) const
{
  return core::bodyDrag(body_, model.environment(),
                        core::rigidBodyMotion(state, state.q.size() - 1, state.vehicle));
}

core::EndMotion VehicleObserver::centre(const core::CableState& state) const
{
  const BodyState body = BodyState::ofNode(state, state.q.size() - 1, state.vehicle, body_.attachment);
  return {body.position, body.velocity};
}

void VehicleObserver::processMeasurement(const VehicleMeasurement& fix, const core::EndTrajectory& nominal,
                                         const StepInput& step, const core::CableModel& model,
                                         const core::CableState& state)
{
  const bool is_position = fix.kind == VehicleMeasurement::Kind::POSITION;
  const core::Vector3 value = is_position ? core::Vector3(fix.value.value() - origin_) : fix.value.value();
  const core::Vector3 expected = is_position ? nominal.position(fix.t) : nominal.velocity(fix.t);
  core::Matrix3 noise = fix.noise();
  if (is_position)
  {
    const core::Vector3 end = value + state.vehicle.orientation * body_.attachment;
    updateChordExcess(end - step.paths.vessel.position(fix.t), fix, step, model, state);
    // What is wrong of the vessel's end is wrong of the vehicle, along the chord: all of it is there along the
    // chord.
    const core::Vector3 squares = filter_state_.filter.stiffness().chord.cwiseAbs2();
    const double vessel_stddev = filter_state_.filter.stiffness().chord.cwiseProduct(step.vessel_stddev).norm();
    noise.diagonal() += vessel_stddev * vessel_stddev / squares.squaredNorm() * squares;
  }
  filter_state_.gate.evaluate(fix, value - expected, noise, filter_state_.filter);
}

void VehicleObserver::updateChordExcess(const core::Vector3& chord, const VehicleMeasurement& fix,
                                        const StepInput& step, const core::CableModel& model,
                                        const core::CableState& state)
{
  const double nominal = (state.q.back() - state.q.front()).head<3>().norm();
  const double excess = chord.norm() - std::max(model.length(state.deployment), nominal);
  const double stddev =
      std::sqrt(fix.stddev().cwiseMin(1e6).squaredNorm() / 3.0 + step.vessel_stddev.squaredNorm());
  filter_state_.chord_excess +=
      STRETCH_SHARE * (std::clamp(excess / stddev, -STRETCH_MOST, STRETCH_MOST) - filter_state_.chord_excess);
}

core::SolveReport VehicleObserver::advanceOneStep(const StepInput& step, const core::CableModel& model,
                                                  core::AdaptiveStepper& stepper, core::CableState& state)
{
  core::BoundaryConditions paths = step.paths;
  paths.vehicle_force = filter_state_.filter.appliedForce();
  if (step.has_attitude)
  {
    Eigen::Quaterniond off = state.vehicle.orientation.conjugate() * step.attitude;
    if (off.w() < 0.0)
      off.coeffs() *= -1.0;
    paths.vehicle_thrust.torque += (body_.inertia + body_.added_inertia)
                                       .cwiseProduct(ATTITUDE_RATE * ATTITUDE_RATE * 2.0 * off.vec() -
                                                     2.0 * ATTITUDE_RATE * state.vehicle.velocity);
  }
  const core::EndMotion before = centre(state);
  const core::SolveReport report = stepper.advance(model, paths, step.to, state);
  if (!report.converged())
    return report;
  filter_state_.filter.predict(step.to - step.from, dragOn(model, state), filter_state_.gate.processNoiseScale());
  const core::EndTrajectory nominal = core::EndTrajectory::between(step.from, before, step.to, centre(state));
  const auto& fixes = history_.fixes();
  auto fix = std::upper_bound(fixes.begin(), fixes.end(), step.from,
                              [](double t, const VehicleMeasurement& other) { return t < other.t; });
  for (; fix != fixes.end() && fix->t <= step.to; ++fix)
    processMeasurement(*fix, nominal, step, model, state);
  if (state.time >= filter_state_.relinearize_at)
  {
    TetherLinearization stiffness = filter_state_.filter.stiffness();
    cable_->update(model, state.deployment);
    if (linearizeTether(solver_, *cable_, state, step.error_rate, stiffness))
      filter_state_.filter.setStiffness(stiffness);
    filter_state_.relinearize_at = state.time + RELINEARIZATION_INTERVAL;
  }
  save(state);
  return report;
}

core::SolveReport VehicleObserver::advance(const core::CableModel& model, core::AdaptiveStepper& stepper,
                                           const core::BoundaryConditions& paths,
                                           const core::Vector3& vessel_stddev, double error_rate, double t,
                                           core::CableState& state)
{
  core::SolveReport total;
  const double late = history_.earliestUnprocessed();
  history_.markProcessed();
  if (late <= state.time)
  {
    total = rewindAndReplay(late, model, stepper, state);
    if (!total.converged())
      return total;
  }
  const double duration = t - state.time;
  const int parts = static_cast<int>(
      std::clamp(std::ceil(duration / LONGEST_STEP - 1e-9), 1.0, static_cast<double>(LEAST_STEPS)));
  const double begin = state.time;
  for (int k = 1; k <= parts; ++k)
  {
    StepInput& step = steps_.emplaceBack();
    // A snapshot state is of use as long as the steps from there on are known.
    while (snapshots_.size() > 1 && steps_.size() > 1 &&
           snapshots_.front().state.time < steps_.front().from - SAME)
      snapshots_.popFront();
    step.from = state.time;
    step.to = k == parts ? t : begin + k * duration / parts;
    step.paths = paths;
    step.has_attitude = attitude_.has_value();
    step.attitude = attitude_.value_or(Eigen::Quaterniond::Identity());
    step.error_rate = error_rate;
    step.vessel_stddev = vessel_stddev;
    const core::SolveReport report = advanceOneStep(step, model, stepper, state);
    total.addCost(report);
    total.status = report.status;
    total.residual = report.residual;
    if (!report.converged())
      return total;
  }
  history_.discardBefore(snapshots_.front().state.time);
  return total;
}

void VehicleObserver::describe(TetherEstimate& e) const
{
  const VehicleErrorStateFilter& filter = filter_state_.filter;
  e.vehicle.position += filter.positionError();
  e.vehicle.velocity += filter.velocityError();
  e.vehicle_position_covariance = filter.positionCovariance();
  e.vehicle_velocity_covariance = filter.velocityCovariance();
  e.vehicle_position_stddev = rootMeanVariance(e.vehicle_position_covariance);
  e.disturbance = filter.disturbance();
  e.disturbance_stddev = std::sqrt(filter.forceStddev().squaredNorm() / 3.0);
  const core::Vector3 along = e.stations.ends.vehicle.normalized();
  const double untransferred_force = along.dot(filter.disturbance() - filter.appliedForce());
  const core::Vector3 vessel = steps_.empty() ? core::Vector3::Zero() : steps_[steps_.size() - 1].vessel_stddev;
  const double vessel_motion_stddev =
      filter.stiffness().vessel_tension_jacobian.transpose().cwiseProduct(vessel).norm();
  const auto sum = [&](double own, double others, double tension)
  {
    return std::sqrt(own * own + others * others + untransferred_force * untransferred_force +
                     std::pow(MODEL_ERROR_STDDEV * tension, 2));
  };
  e.vessel_tension_stddev =
      sum(filter.tensionStddev(filter.stiffness().vessel), vessel_motion_stddev, e.vessel_tension);
  e.vehicle_tension_stddev =
      sum(filter.tensionStddev(filter.stiffness().vehicle), vessel_motion_stddev, e.vehicle_tension);
}

bool VehicleObserver::isInconsistent(double t) const
{
  return filter_state_.gate.isInconsistent(t);
}

bool VehicleObserver::exceedsTetherLength() const
{
  return filter_state_.chord_excess > STRETCH_LIMIT;
}

}  // namespace tether_monitor::monitor
