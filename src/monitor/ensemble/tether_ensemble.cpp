#include "tether_monitor/monitor/ensemble/tether_ensemble.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "tether_monitor/monitor/ensemble/improbability.h"
#include "tether_monitor/monitor/estimate/estimate_summary.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double LIKENESS_TIME = 0.5;  // [s] in which what a member's tension is off stays alike
constexpr double LEAST_LIKENESS = 0.01;
constexpr double LONGEST_STEP = 0.1;              // [s] between corrections
constexpr double RELINEARIZATION_INTERVAL = 1.0;  // [s] between linearisations of the tether
constexpr double LINEARIZATION_SHARE = 0.2;       // of the newest
constexpr double FIRST_WAIT = 5.0;                // [s] for the first three positions
constexpr double FIRST_DRIFT = 0.3;               // speed by which the vehicle may part from the vessel then [m/s]
constexpr double FRESH_INTERVALS = 4.0;  // so many usual intervals a position is fresh enough to begin with
constexpr int FIRST_FIXES = 3, MEDIAN_OF = 5, MOST_PARTS = 128;
constexpr double MODEL_ERROR = 0.005;       // of a tension, relative: mesh, step, rounding of motions [-]
constexpr double LARGEST_CORRECTION = 0.5;  // of a tension, by what the nominal vehicle has not followed yet

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

TetherEnsemble::TetherEnsemble(const Config& config)
  : navigation_(config.navigation),
    body_(config.vehicle_body),
    invalid_timeout_(config.invalid_timeout),
    solver_(config.elements + 1),
    members_(config),
    filter_(config),
    summary_(config.uncertainty.members),
    position_(MemberVectors::Zero(3, config.uncertainty.members)),
    initialized_at_(-std::numeric_limits<double>::infinity()),
    timing_(config.navigation.latency)
{
  body_.attachment = config.vehicle.attachment;
  own_.vessel_correction = own_.vehicle_correction = residual_ =
      Eigen::RowVectorXd::Zero(config.uncertainty.members);
  summary_.prepare(config.elements, config.uncertainty.members);
}

Rejection TetherEnsemble::check(const VehicleMeasurement& fix) const
{
  return fix.t <= initialized_at_ ? Rejection::NONE : history_.check(fix, filter_.earliestTime());
}

Rejection TetherEnsemble::add(const VehicleMeasurement& fix)
{
  if (fix.t <= initialized_at_)
    return Rejection::NONE;
  const Rejection rejection = history_.add(fix, filter_.earliestTime());
  if (rejection == Rejection::NONE && fix.measuresPosition(0))
    timing_.add(fix.t, filter_.latestTime());
  return rejection;
}

void TetherEnsemble::clear()
{
  history_.clear();
  filter_.prepare();
  attitude_.reset();
  initialized_at_ = -std::numeric_limits<double>::infinity();
  timing_.clear();
}

double TetherEnsemble::oldestUsableTime(double t) const
{
  return t - navigation_.latency - std::max(invalid_timeout_, FRESH_INTERVALS * timing_.interval());
}

std::optional<MeasuredVector> TetherEnsemble::initialPositionEstimate(double t,
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

bool TetherEnsemble::isReady(double t) const
{
  const auto& fixes = history_.fixes();
  for (int axis = 0; axis < 3; ++axis)
  {
    int n = 0;
    double first = t;
    for (const VehicleMeasurement& fix : fixes)
      if (fix.measuresPosition(axis) && fix.t > oldestUsableTime(t))
        first = n++ == 0 ? fix.t : first;
    if (n == 0 || (n < FIRST_FIXES && t - first <= FIRST_WAIT + navigation_.latency))
      return false;
  }
  return true;
}

core::SolveReport TetherEnsemble::initialize(core::SteadyStateSolver& statics, const core::CableModel& model,
                                             const core::SteadyEnds& ends, const core::Matrix3& covariance,
                                             const core::Vector3& thrust, VehicleInitialization& start) const
{
  const UnknownForce& force = filter_.unknownForce();
  const double stddev = std::hypot(force.slow_stddev, force.fast_stddev);
  const InitializationInputs inputs{ends, covariance, thrust, core::Vector3::Constant(stddev)};
  return findVehicleInitialization(statics, model, inputs, start);
}

bool TetherEnsemble::findMembers(core::SteadyStateSolver& statics, const core::CableModel& model,
                                 const core::SteadyEnds& ends, const core::Matrix3& covariance,
                                 const core::Vector3& velocity_stddev, const core::Vector3& thrust,
                                 VehicleInitialization& start) const
{
  const EnsembleStartInputs inputs{ends, covariance, velocity_stddev, thrust, filter_.unknownForce()};
  start.measured_covariance = covariance;
  return findEnsembleStart(filter_.prior(), members_.size(), statics, model, inputs, start.shape, start.ensemble);
}

core::CableModel TetherEnsemble::modelWithInitialForces(const core::CableModel& model,
                                                        const VehicleInitialization& start,
                                                        const core::Vector3& thrust) const
{
  core::RigidBody body = body_;
  body.force += start.force + thrust;
  return model.withBodies({std::nullopt, body});
}

void TetherEnsemble::prepare(const core::CableModel& model)
{
  solver_ = core::EndDynamicStiffnessSolver(model.nodes());
  members_.prepare(model);
  summary_.prepare(model.elements(), members_.size());
  filter_.prepare();
}

void TetherEnsemble::begin(const VehicleInitialization& start, double measured_at, CableSimulation& simulation)
{
  solver_ = core::EndDynamicStiffnessSolver(simulation.model.nodes());
  summary_.prepare(simulation.model.elements(), members_.size());
  initialized_at_ = simulation.state.time;
  origin_ = simulation.origin();
  if (attitude_)
    simulation.state.vehicle.orientation = *attitude_;
  members_.begin(start.ensemble, simulation);
  TetherLinearization tether;
  tether.mass = (body_.mass + body_.added_mass.mean()) * core::Matrix3::Identity();
  linearizeTether(solver_, members_.cable(0), members_.state(0), 1.0, tether);
  filter_.begin(start.ensemble, start.measured_covariance, tether, members_.motion(), simulation.state.time,
                measured_at);
  relinearize_at_ = simulation.state.time;
  history_.discardBefore(simulation.state.time);
  history_.markProcessed();
  summarize(core::Vector3::Zero());
  linearize(1.0);
  simulation.state = members_.state(summary_.representative().index());
}

void TetherEnsemble::linearize(double error_rate)
{
  const int i = summary_.representative().index();
  TetherLinearization tether = filter_.motionError().tether(), now = tether;
  if (linearizeTether(solver_, members_.cable(i), members_.state(i), error_rate, now))
  {
    tether.blend(now, LINEARIZATION_SHARE);
    filter_.setTether(tether);
  }
  relinearize_at_ = members_.state(i).time + RELINEARIZATION_INTERVAL;
}

void TetherEnsemble::summarize(const core::Vector3& vessel_stddev)
{
  const MotionErrorFilter& error = filter_.motionError();
  const TetherLinearization& tether = error.tether();
  const MemberMotion& motion = members_.motion();
  const auto jacobian = [](const TensionJacobian& tension)
  { return MotionErrorFilter::tensionJacobian(tension).row(0).eval(); };
  const auto vessel = jacobian(tether.vessel), vehicle = jacobian(tether.vehicle);
  for (int i = 0; i < members_.size(); ++i)
  {
    const auto limited = [](double x, double most) { return std::clamp(x, -most, most); };
    own_.vessel_correction[i] =
        limited(vessel * error.means().col(i), LARGEST_CORRECTION * motion.vessel_tension[i]);
    own_.vehicle_correction[i] =
        limited(vehicle * error.means().col(i), LARGEST_CORRECTION * motion.vehicle_tension[i]);
    position_.col(i) = motion.position.col(i) + error.means().col(i).segment<3>(MotionErrorFilter::POSITION);
  }
  const double shaking = tether.vesselTensionStddev(vessel_stddev);
  const auto own = [&](const TensionJacobian& tension, double mean)
  {
    return std::sqrt(std::pow(error.tensionStddev(tension), 2) + shaking * shaking +
                     std::pow(MODEL_ERROR * mean, 2));
  };
  own_.vessel = own(tether.vessel, motion.vessel_tension.mean());
  own_.vehicle = own(tether.vehicle, motion.vehicle_tension.mean());
  followLoadCell(error.tensionCovariance(tether.vessel, tether.vehicle) + shaking * shaking);
  summary_.update(members_, position_, own_);
}

// (E23): what a reading was off from every member a moment ago, it is off now.
void TetherEnsemble::followLoadCell(double common)
{
  const LoadCellRecord& reading = filter_.loadCell();
  const double age = std::max(members_.state(0).time - reading.t(), 0.0) / LIKENESS_TIME;
  const double likeness = std::exp(-0.5 * age * age);
  if (likeness < LEAST_LIKENESS)
    return;
  const double of_vessel = own_.vessel * own_.vessel;
  const double of_residual = of_vessel + reading.noiseVariance();
  if (!(of_residual > 0.0))
    return;
  residual_ = -(reading.nominal() + filter_.parameters().row(TENSION_BIAS) + own_.vessel_correction);
  residual_.array() += reading.tension();
  own_.vessel_correction += likeness * of_vessel / of_residual * residual_;
  own_.vehicle_correction += likeness * common / of_residual * residual_;
  own_.vessel = std::sqrt(of_vessel * (1.0 - likeness * likeness * of_vessel / of_residual));
  own_.vehicle =
      std::sqrt(std::max(own_.vehicle * own_.vehicle - likeness * likeness * common * common / of_residual, 0.0));
}

core::SolveReport TetherEnsemble::advanceOnePart(const core::CableModel& model,
                                                 const core::BoundaryConditions& paths,
                                                 const core::Vector3& vessel_stddev, double error_rate, double t)
{
  const core::SolveReport report =
      members_.advance(model, paths, t, filter_.parameters(), filter_.appliedForce(), attitude_);
  if (!report.converged())
    return report;
  EnsembleFilter::VesselNoise noise;
  noise.stddev = vessel_stddev;
  noise.tension = filter_.motionError().tether().vesselTensionStddev(vessel_stddev);
  filter_.update(t, members_.motion(), noise, origin_, history_);
  if (t >= relinearize_at_)
    linearize(error_rate);
  return report;
}

core::SolveReport TetherEnsemble::advance(const core::CableModel& model, const core::BoundaryConditions& paths,
                                          const core::Vector3& vessel_stddev, double error_rate, double t,
                                          core::CableState& state)
{
  const double begin = members_.state(0).time;
  const int parts =
      static_cast<int>(std::clamp(std::ceil((t - begin) / LONGEST_STEP - 1e-9), 1.0, 1.0 * MOST_PARTS));
  core::SolveReport total;
  for (int k = 1; k <= parts; ++k)
  {
    const double to = k == parts ? t : begin + k * (t - begin) / parts;
    const core::SolveReport report = advanceOnePart(model, paths, vessel_stddev, error_rate, to);
    total.addCost(report);
    total.status = report.status;
    total.residual = report.residual;
    if (!report.converged())
      return total;
  }
  history_.discardBefore(filter_.earliestTime());
  summarize(vessel_stddev);
  state = members_.state(summary_.representative().index());
  return total;
}

void TetherEnsemble::describe(const core::DeployedCable& cable, TetherEstimate& e) const
{
  const MotionErrorFilter& error = filter_.motionError();
  const auto scaled = [](core::Vector3& force, double size)
  {
    if (force.norm() > 0.0)
      force *= std::max(size, 0.0) / force.norm();
  };
  e.stations.tension = summary_.tension();
  e.stations.max_element_rotation = summary_.maxElementRotation();
  summary_.representative().blend(e.stations);
  // The end that is shown is where the vehicle is believed to be; what a member is off goes out along the tether.
  const core::Vector3 mean = position_.rowwise().mean();
  const std::size_t last = e.stations.position.size() - 1;
  const core::Vector3 off = e.vehicle.position - origin_ - mean + summary_.representative().offset(last);
  for (std::size_t k = 0; k <= last; ++k)
    e.stations.position[k] -= static_cast<double>(k) / static_cast<double>(last) * off;
  scaled(e.stations.ends.vessel, summary_.vessel().median);
  scaled(e.stations.ends.vehicle, summary_.vehicle().median);
  monitor::summarize(cable, e);
  e.vehicle.position = mean + origin_;
  e.vehicle.orientation = summary_.representative().blended(e.vehicle.orientation);
  const auto error_velocity = error.means().middleRows<3>(MotionErrorFilter::VELOCITY);
  e.vehicle.velocity = members_.motion().velocity.rowwise().mean() + error_velocity.rowwise().mean();
  e.vehicle_position_covariance =
      covarianceOf(position_) +
      error.covariance().block<3, 3>(MotionErrorFilter::POSITION, MotionErrorFilter::POSITION);
  e.vehicle_velocity_covariance =
      covarianceOf(members_.motion().velocity) +
      error.covariance().block<3, 3>(MotionErrorFilter::VELOCITY, MotionErrorFilter::VELOCITY);
  e.vehicle_position_stddev = rootMeanVariance(e.vehicle_position_covariance);
  const core::Vector3 force = error.means().middleRows<3>(MotionErrorFilter::SLOW).rowwise().mean() +
                              error.means().middleRows<3>(MotionErrorFilter::FAST).rowwise().mean();
  e.disturbance = force;
  core::Matrix3 spread = covarianceOf(error.means().middleRows<3>(MotionErrorFilter::SLOW));
  spread += error.covariance().block<3, 3>(MotionErrorFilter::SLOW, MotionErrorFilter::SLOW);
  e.disturbance_stddev = rootMeanVariance(spread);
  e.vessel_tension_stddev = summary_.vessel().stddev;
  e.vehicle_tension_stddev = summary_.vehicle().stddev;
  e.vessel_tension_p05 = summary_.vessel().p05;
  e.vessel_tension_p95 = summary_.vessel().p95;
  e.vehicle_tension_p05 = summary_.vehicle().p05;
  e.vehicle_tension_p95 = summary_.vehicle().p95;
  e.max_tension_p95 = summary_.largest().p95;
  e.tension_stddev = summary_.tensionStddev();
  e.position_stddev = summary_.positionStddev();
  e.contact_probability = summary_.contactProbability();
}

void TetherEnsemble::reportImprobable(const std::function<void(Subject, Implausibility)>& note) const
{
  if (std::isfinite(initialized_at_))
    findImprobable(filter_, note);
}

bool TetherEnsemble::isInconsistent(double t) const
{
  return filter_.gate().isInconsistent(t);
}

bool TetherEnsemble::isValid(const core::CableModel& model) const
{
  return history_.isValid() && filter_.isValid() && members_.isValid(model) &&
         summary_.representative().isValid(members_.size(), model.elements());
}

}  // namespace tether_monitor::monitor
