#include "tether_monitor/monitor/ensemble/ensemble_filter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr std::size_t LEAST_TICKS = 128, MOST_TICKS = 1024, TRANSFORMS = 1024;
constexpr double OUT_OF_ORDER = 3.0;             // [s] by which a measurement may be later than the latency
constexpr double LONGEST_TICK = 0.1;             // [s]
constexpr double SAME = 1e-9;                    // [s]
constexpr double WALK_INTERVAL = 1.0;            // [s] between steps of the parameters' walk
constexpr double INITIAL_VELOCITY_STDDEV = 0.1;  // [m/s]
constexpr double UNBALANCED_SHARE = 0.2;         // of the force, at the start
constexpr double PULL_RATE = 0.3;                // [1/s] with which a nominal vehicle follows its mean
constexpr double PULL_ACCELERATION = 0.3;        // at most [m/s^2]
constexpr double TRANSFER_TIME = 4.0;            // [s] in which it takes over what is known of the force
constexpr double TENSION_MEMORY = 20.0;          // [s] in which errors of a predicted tension are the same
constexpr double TENSION_MODEL_ERROR = 0.005;    // of a predicted tension, relative
constexpr double BELIEVED_RESIDUAL = 4.0;        // standard deviations
constexpr double DIRECTION_MEMORY = 5.0;         // [s] likewise of a direction
constexpr double POSITION_MEMORY = 10.0;         // [s] in which positions tell the same of the parameters
constexpr double PLACE_MODEL_ERROR = 0.05;       // of the distance of the ends [m]
constexpr double PLACE_MEMORY = 60.0;            // [s] in which it stays
constexpr double DYNAMIC_MODEL_ERROR = 0.5;      // of what a tension varies by, standard deviations
constexpr double START_MODEL_ERROR = 0.3;        // of a tension at the start, relative
constexpr double START_MEMORY = 15.0;            // [s]
constexpr double RESET_PLACE = 0.5;              // [m] by which a place is doubted after a reset
}  // namespace

std::size_t EnsembleFilter::ticksFor(const Config& config)
{
  const double rate = std::max({config.rate, 1.0 / config.solver.step, 1.0 / LONGEST_TICK});
  return static_cast<std::size_t>(std::clamp(1.2 * rate * (config.navigation.latency + OUT_OF_ORDER),
                                             static_cast<double>(LEAST_TICKS), static_cast<double>(MOST_TICKS)));
}

EnsembleFilter::EnsembleFilter(const Config& config)
  : count_(config.uncertainty.members),
    prior_(parameterPrior(config)),
    unknown_force_(unknownForceOf(config)),
    sensor_stddev_(config.uncertainty.tension_stddev),
    direction_stddev_(config.uncertainty.direction_stddev),
    pull_limit_(PULL_ACCELERATION * config.vehicle_body.mass),
    parameters_(ParameterMatrix::Zero(PARAMETERS, count_)),
    motion_(count_),
    transferred_(MemberVectors::Zero(3, count_)),
    applied_(MemberVectors::Zero(3, count_)),
    ticks_(ticksFor(config)),
    transforms_(TRANSFORMS),
    random_(7),
    sight_{MotionErrorFilter::Jacobian::Zero(), MemberVectors::Zero(3, count_),   MemberVectors::Zero(3, count_),
           MemberVectors::Zero(3, count_),      Eigen::RowVectorXd::Zero(count_), core::Matrix3::Identity()},
    sample_(PARAMETERS, count_),
    load_cell_(count_),
    spacing_((config.navigation.latency + OUT_OF_ORDER) / static_cast<double>(ticks_.capacity() - 8))
{
  for (Tick& tick : ticks_.storage())
  {
    tick.motion = MemberMotion(count_);
    tick.applied = applied_;
    motion_.save(tick.belief);
  }
  for (Transform& slot : transforms_)
    slot.transform = EnsembleTransform(count_);
}

void EnsembleFilter::begin(const EnsembleStart& start, const core::Matrix3& position_covariance,
                           const TetherLinearization& tether, const MemberMotion& motion, double t,
                           double measured_at)
{
  const double slow = std::pow(unknown_force_.slow_stddev, 2), fast = std::pow(unknown_force_.fast_stddev, 2);
  motion_ = MotionErrorFilter(count_);
  motion_.start(unknown_force_, position_covariance, INITIAL_VELOCITY_STDDEV,
                UNBALANCED_SHARE * std::sqrt(slow + fast), tether);
  for (int i = 0; i < count_; ++i)
  {
    const MemberStart& member = start.members[i];
    parameters_.col(i) = member.parameters;
    motion_.means().col(i).segment<3>(MotionErrorFilter::SLOW) = slow / (slow + fast) * member.force;
    motion_.means().col(i).segment<3>(MotionErrorFilter::FAST) = fast / (slow + fast) * member.force;
    transferred_.col(i) = member.force;
  }
  applied_ = transferred_;
  gate_.start(t, measured_at);
  walked_at_ = began_at_ = t;
  load_cell_.clear();
  first_transform_ = next_transform_;
  ticks_.clear();
  Tick& tick = ticks_.emplaceBack();
  tick.t = t;
  tick.motion = motion;
  tick.applied = applied_;
  motion_.save(tick.belief);
}

// What brings a nominal vehicle to its mean, and what is known of the force.
void EnsembleFilter::feedBack(double dt)
{
  const double share = 1.0 - std::exp(-dt / TRANSFER_TIME);
  const core::Matrix3& mass = motion_.tether().mass;
  for (int i = 0; i < count_; ++i)
  {
    const auto mean = motion_.means().col(i);
    const core::Vector3 known =
        mean.segment<3>(MotionErrorFilter::SLOW) + mean.segment<3>(MotionErrorFilter::FAST);
    transferred_.col(i) += share * (known - transferred_.col(i));
    core::Vector3 pull = mass * (PULL_RATE * PULL_RATE * mean.segment<3>(MotionErrorFilter::POSITION) +
                                 2.0 * PULL_RATE * mean.segment<3>(MotionErrorFilter::VELOCITY));
    const double size = pull.norm();
    if (size > pull_limit_)
      pull *= pull_limit_ / size;
    applied_.col(i) = transferred_.col(i) + pull;
  }
}

void EnsembleFilter::update(double t, const MemberMotion& moved, const VesselNoise& noise,
                            const core::Vector3& origin, MeasurementHistory& history)
{
  const double dt = t - ticks_.back().t;
  const bool merges = ticks_.size() > 1 && ticks_.back().t - ticks_[ticks_.size() - 2].t < spacing_;
  if (merges)
    ticks_.resizeTo(ticks_.size() - 1);
  Tick& now = ticks_.emplaceBack();
  now.t = t;
  now.motion = moved;
  now.applied = applied_;
  now.noise = noise;

  // From the last tick before the earliest measurement that is new.
  const double earliest = history.earliestUnprocessed();
  history.markProcessed();
  std::size_t from = ticks_.size() - 1;
  while (from > 1 && ticks_[from - 1].t >= earliest - SAME)
    --from;
  motion_.restore(ticks_[from - 1].belief);
  std::size_t k = 0;
  const auto& fixes = history.fixes();
  while (k < fixes.size() && fixes[k].t <= ticks_[from - 1].t)
    ++k;
  for (std::size_t tick = from; tick < ticks_.size(); ++tick)
  {
    motion_.predict(ticks_[tick].t - ticks_[tick - 1].t, ticks_[tick].applied);
    for (; k < fixes.size() && fixes[k].t <= ticks_[tick].t; ++k)
      process(history.fix(k), tick, origin);
    motion_.save(ticks_[tick].belief);
  }
  walk(t);
  feedBack(dt);
  tension_spread_.add(moved.vessel_tension.mean(), dt);
}

// Of a tension, relative: a tether that was not in a steady state when this began pulls differently.
double EnsembleFilter::startError(double t) const
{
  return START_MODEL_ERROR * std::exp(-(t - began_at_) / START_MEMORY);
}

// What every member predicts of a measurement, between two ticks.
bool EnsembleFilter::look(const VehicleMeasurement& fix, std::size_t tick, const core::Vector3& origin)
{
  using Kind = VehicleMeasurement::Kind;
  const Tick &a = ticks_[tick - 1], &b = ticks_[tick];
  const double share = b.t > a.t ? std::clamp((fix.t - a.t) / (b.t - a.t), 0.0, 1.0) : 1.0;
  const auto blend = [&](const auto& x, const auto& y) { return ((1.0 - share) * x + share * y).eval(); };
  const MotionErrorFilter::Means& means = motion_.means();
  core::Vector3 value = fix.value.value();
  sight_.noise = fix.noise();
  switch (fix.kind)
  {
    case Kind::POSITION:
    {
      value -= origin;
      sight_.jacobian = MotionErrorFilter::positionJacobian();
      for (int i = 0; i < count_; ++i)
        sight_.predicted.col(i) = blend(a.motion.position.col(i), b.motion.position.col(i));
      // What is wrong of the vessel's end is wrong of the vehicle, along the chord; and so is what is wrong of the
      // tether's shape, which is the same for long.
      const core::Vector3& chord = motion_.tether().chord;
      const double shaking = chord.cwiseProduct(b.noise.stddev).norm();
      const double variance =
          shaking * shaking + PLACE_MODEL_ERROR * PLACE_MODEL_ERROR * position_rate_.repeatsIn(PLACE_MEMORY);
      sight_.noise += variance * chord * chord.transpose();
      break;
    }
    case Kind::VELOCITY:
      sight_.jacobian = MotionErrorFilter::velocityJacobian();
      for (int i = 0; i < count_; ++i)
        sight_.predicted.col(i) = blend(a.motion.velocity.col(i), b.motion.velocity.col(i));
      break;
    case Kind::TENSION:
    {
      sight_.jacobian = MotionErrorFilter::tensionJacobian(motion_.tether().vessel);
      sight_.predicted.setZero();
      sight_.nominal_tension = (1.0 - share) * a.motion.vessel_tension + share * b.motion.vessel_tension;
      sight_.predicted.row(0) = sight_.nominal_tension + parameters_.row(TENSION_BIAS);
      const double mean = sight_.predicted.row(0).mean();
      const double variance = std::pow(sensor_stddev_ * value.x(), 2) + std::pow(TENSION_MODEL_ERROR * mean, 2) +
                              DYNAMIC_MODEL_ERROR * DYNAMIC_MODEL_ERROR * tension_spread_.variance +
                              std::pow(startError(fix.t) * mean, 2) + std::pow(b.noise.tension, 2);
      sight_.noise(0, 0) = std::max(variance, 1e-6) * tension_rate_.repeatsIn(TENSION_MEMORY);
      break;
    }
    case Kind::DIRECTION:
    {
      sight_.jacobian.setZero();
      const core::Vector3 mean = b.motion.direction.rowwise().mean().normalized();
      core::Vector3 across = core::Vector3::UnitZ().cross(mean);
      across = across.norm() > 1e-3 ? core::Vector3(across.normalized()) : core::Vector3::UnitX();
      const core::Vector3 up = mean.cross(across);
      for (int i = 0; i < count_; ++i)
        sight_.predicted.col(i) = blend(a.motion.direction.col(i), b.motion.direction.col(i)) +
                                  parameters_(DIRECTION_AZIMUTH, i) * across +
                                  parameters_(DIRECTION_ELEVATION, i) * up;
      sight_.noise =
          core::Matrix3::Identity() * std::pow(direction_stddev_, 2) * direction_rate_.repeatsIn(DIRECTION_MEMORY);
      break;
    }
  }
  for (int i = 0; i < count_; ++i)
  {
    sight_.predicted.col(i) += sight_.jacobian * means.col(i);
    for (int axis = 0; axis < 3; ++axis)
      if (!fix.value.isMeasured(axis))
        sight_.predicted(axis, i) = 0.0;
    sight_.innovations.col(i) = value - sight_.predicted.col(i);
  }
  return sight_.innovations.allFinite();
}

bool EnsembleFilter::isAccepted(const VehicleMeasurement& fix, const core::Vector3& innovation)
{
  const core::Matrix3 spread = covarianceOf(sight_.predicted);
  const core::Matrix3 S = motion_.innovationCovariance(sight_.jacobian, sight_.noise) + spread;
  if (fix.kind == VehicleMeasurement::Kind::TENSION)
  {
    // Of this reading alone: in S it counts only for its share of those that tell the same.
    const double shared = sight_.noise(0, 0) * (1.0 - 1.0 / tension_rate_.repeatsIn(TENSION_MEMORY));
    const double measured = fix.value.value().x();
    tension_residual_ = {fix.t, measured, measured - innovation.x(), std::sqrt(S(0, 0) - shared)};
  }
  switch (gate_.evaluate(fix, innovation, S, spread))
  {
    case InnovationGate::Verdict::ACCEPT:
      return true;
    case InnovationGate::Verdict::REJECT:
      return false;
    case InnovationGate::Verdict::REACQUIRE:
      motion_.inflate(innovation.norm(), unknown_force_.slow_stddev);
      return true;
    case InnovationGate::Verdict::RESET:
      motion_.inflate(innovation.norm(), unknown_force_.slow_stddev);
      reset();
      return true;
  }
  return false;
}

ReadingRate& EnsembleFilter::rateOf(VehicleMeasurement::Kind kind)
{
  if (kind == VehicleMeasurement::Kind::TENSION)
    return tension_rate_;
  return kind == VehicleMeasurement::Kind::DIRECTION ? direction_rate_ : position_rate_;
}

void EnsembleFilter::process(VehicleMeasurement& fix, std::size_t tick, const core::Vector3& origin)
{
  const bool is_new = fix.processed == VehicleMeasurement::NONE;
  if (is_new)
  {
    fix.processed = static_cast<int>(next_transform_++ % static_cast<long>(TRANSFORMS));
    transforms_[fix.processed].t = fix.t;
    transforms_[fix.processed].accepted = false;
    transforms_[fix.processed].learnt_at = ticks_.back().t;
    rateOf(fix.kind).note(fix.t);
  }
  Transform& slot = transforms_[fix.processed];
  if (slot.t != fix.t || (!is_new && !slot.accepted) || !look(fix, tick, origin))
    return;
  if (is_new)
  {
    const core::Vector3 innovation = sight_.innovations.rowwise().mean();
    slot.accepted = isAccepted(fix, innovation);
    if (!slot.accepted)
      return;
    if (fix.kind == VehicleMeasurement::Kind::TENSION)
      believe(fix);
    learn(fix, ticks_[tick].t, slot.transform);
  }
  motion_.correct(sight_.jacobian, sight_.innovations, gate_.noiseVarianceScale() * sight_.noise);
  // The unknown forces go with the parameters; where the vehicle is, the next measurements tell.
  slot.transform.apply(motion_.means().bottomRows<6>());
}

// (E23)
void EnsembleFilter::believe(const VehicleMeasurement& reading)
{
  const double tension = reading.value.value().x();
  if (reading.t >= load_cell_.t() && std::abs(tension_residual_.normalized()) <= BELIEVED_RESIDUAL)
    load_cell_.add(reading.t, tension, std::pow(sensor_stddev_ * tension, 2), sight_.nominal_tension);
}

// (E9): what is predicted, had the members known what was learnt since t; the last transform is its own.
void EnsembleFilter::hindcast(double t)
{
  const auto slot = [&](long n) -> const Transform&
  { return transforms_[static_cast<std::size_t>(n) % TRANSFORMS]; };
  const long end = next_transform_ - 1;
  const long oldest = std::max(first_transform_, next_transform_ - static_cast<long>(TRANSFORMS));
  long from = end;
  while (from > oldest && slot(from - 1).learnt_at > t)
    --from;
  for (long n = from; n < end; ++n)
    if (slot(n).accepted)
      slot(n).transform.apply(sight_.hindcast);
}

// Positions that follow each other closely tell the same of the parameters: only as much as one in ten seconds.
void EnsembleFilter::learn(const VehicleMeasurement& fix, double moved_at, EnsembleTransform& transform)
{
  const bool is_of_vehicle =
      fix.kind == VehicleMeasurement::Kind::POSITION || fix.kind == VehicleMeasurement::Kind::VELOCITY;
  const double repeats = is_of_vehicle ? position_rate_.repeatsIn(POSITION_MEMORY) : 1.0;
  sight_.hindcast = sight_.predicted;
  if (is_of_vehicle)
    hindcast(moved_at);
  const core::Vector3 innovation =
      (sight_.predicted + sight_.innovations).rowwise().mean() - sight_.hindcast.rowwise().mean();
  transform.set(
      sight_.hindcast, innovation,
      repeats * motion_.innovationCovariance(sight_.jacobian, gate_.noiseVarianceScale() * sight_.noise));
  transform.apply(parameters_);
}

// Nothing is known of the parameters but what was known beforehand.
void EnsembleFilter::reset()
{
  random_.fillUncorrelated(sample_);
  for (int k = 0; k < PARAMETERS; ++k)
    parameters_.row(k) = prior_.stddev[k] * sample_.row(k);
  motion_.inflate(RESET_PLACE, unknown_force_.slow_stddev);
  first_transform_ = next_transform_;
  ++resets_;
}

void EnsembleFilter::forgetWhatIsToldAnew(const Config& before, const Config& now)
{
  motion_.setForce(unknown_force_);
  const std::vector<Parameter> told = parametersToldAnew(before, now);
  if (told.empty())
    return;
  random_.fillUncorrelated(sample_);
  for (const Parameter k : told)
    parameters_.row(k) = prior_.stddev[k] * sample_.row(k);
  motion_.inflate(RESET_PLACE, 0.0);
  first_transform_ = next_transform_;
}

// Stationary first-order Gauss-Markov processes.
void EnsembleFilter::walk(double t)
{
  const double dt = t - walked_at_;
  if (dt < WALK_INTERVAL)
    return;
  walked_at_ = t;
  random_.fillUncorrelated(sample_);
  for (int k = 0; k < PARAMETERS; ++k)
  {
    const double phi = std::exp(-dt / prior_.memory[k]);
    parameters_.row(k) = phi * parameters_.row(k) +
                         prior_.stddev[k] * std::sqrt(-std::expm1(-2.0 * dt / prior_.memory[k])) * sample_.row(k);
  }
}

bool EnsembleFilter::isValid() const
{
  if (!parameters_.allFinite() || parameters_.cols() != count_ || !motion_.isValid() || !applied_.allFinite() ||
      motion_.means().cols() != count_ || !load_cell_.isValid(count_) || transforms_.size() != TRANSFORMS)
    return false;
  for (std::size_t k = 0; k < ticks_.size(); ++k)
    if (!std::isfinite(ticks_[k].t) || !ticks_[k].belief.means.allFinite() ||
        (k > 0 && ticks_[k].t < ticks_[k - 1].t))
      return false;
  for (const Transform& slot : transforms_)
    if (!slot.transform.isValid())
      return false;
  return true;
}

}  // namespace tether_monitor::monitor
