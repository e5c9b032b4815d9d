#include "tether_monitor/monitor/estimator/observed_vehicle_end.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/estimate/estimate_summary.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double BACK = 0.9;  // of a threshold: narrower, and what was too wide is not any more

double largestTensionStddev(const TetherEstimate& e)
{
  return std::max(e.vessel_tension_stddev, e.vehicle_tension_stddev);
}
}  // namespace

ObservedVehicleEnd::ObservedVehicleEnd(const Config& config)
  : attachment_(config.vehicle.attachment),
    least_stddev_(config.vehicle.least_stddev),
    navigation_(config.navigation),
    uncertainty_(config.uncertainty),
    pose_timeout_(config.pose_timeout),
    invalid_timeout_(config.invalid_timeout),
    working_load_(config.tether.working_load),
    ensemble_(config)
{
}

VehicleMeasurement ObservedVehicleEnd::positionFix(const PoseMeasurement& pose) const
{
  return {pose.t - navigation_.latency, VehicleMeasurement::Kind::POSITION,
          pose.position.withDefaultStddev(navigation_.position_stddev).withLeastStddev(least_stddev_)};
}

VehicleMeasurement ObservedVehicleEnd::velocityFix(const TwistMeasurement& twist) const
{
  return {twist.t - navigation_.latency, VehicleMeasurement::Kind::VELOCITY,
          twist.velocity.withDefaultStddev(navigation_.velocity_stddev)};
}

Rejection ObservedVehicleEnd::check(const PoseMeasurement* pose, const TwistMeasurement* twist) const
{
  Rejection rejection = Rejection::NONE;
  if (pose && pose->isAttitude())
    return track_.checkAttitude(pose->t, *pose->orientation, pose->angular_velocity);
  if (pose && pose->position.isEmpty())
    return Rejection::NOT_MEASURED;
  if (pose)
    rejection =
        track_.checkPose(pose->t, pose->position.value(), pose->orientation.value_or(track_.lastOrientation()));
  if (pose && canBeReordered(rejection))
    rejection = ensemble_.check(positionFix(*pose));
  if (canBeReordered(rejection) && twist)
    rejection = track_.checkTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
  if (twist && canBeReordered(rejection) && !twist->velocity.isEmpty())
    rejection = ensemble_.check(velocityFix(*twist));
  return canBeReordered(rejection) ? Rejection::NONE : rejection;
}

Rejection ObservedVehicleEnd::add(const PoseMeasurement* pose, const TwistMeasurement* twist)
{
  const Rejection rejection = check(pose, twist);
  if (rejection != Rejection::NONE)
    return rejection;
  if (pose && pose->isAttitude())
  {
    track_.addAttitude(pose->t, *pose->orientation, pose->angular_velocity);
    ensemble_.setAttitude(pose->orientation->normalized());
    return Rejection::NONE;
  }
  if (pose)
  {
    const Rejection order =
        track_.addPose(pose->t, pose->position.value(), pose->orientation.value_or(track_.lastOrientation()));
    if (pose->orientation && order == Rejection::NONE)
      ensemble_.setAttitude(pose->orientation->normalized());
    ensemble_.add(positionFix(*pose));
  }
  if (twist)
  {
    track_.addTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
    if (!twist->velocity.isEmpty())
      ensemble_.add(velocityFix(*twist));
  }
  return Rejection::NONE;
}

Rejection ObservedVehicleEnd::addTension(double t, double tension)
{
  MeasuredVector value = MeasuredVector::withStddev({tension, 0.0, 0.0}, core::Vector3::Ones());
  value.setNotMeasured(1);
  value.setNotMeasured(2);
  return ensemble_.add({t, VehicleMeasurement::Kind::TENSION, value});
}

Rejection ObservedVehicleEnd::addDirection(double t, const core::Vector3& direction)
{
  const double length = direction.norm();
  if (!(length > 0.0) || !std::isfinite(length))
    return Rejection::NOT_FINITE;
  return ensemble_.add(
      {t, VehicleMeasurement::Kind::DIRECTION,
       MeasuredVector::withStddev(direction / length, core::Vector3::Constant(uncertainty_.direction_stddev))});
}

void ObservedVehicleEnd::setThrust(double t, const core::Wrench& thrust)
{
  thrust_.add(t, thrust);
}

void ObservedVehicleEnd::clear()
{
  track_.clear();
  ensemble_.clear();
  thrust_.clear();
}

double ObservedVehicleEnd::overdue(double age) const
{
  return std::max(ensemble_.overdueTime(age), 0.0);
}

void ObservedVehicleEnd::aimAtStart(double t, EndTargets& targets)
{
  const core::Vector3& velocity = targets.vessel.velocity;
  targets.vehicle_age = ensemble_.measuredAge(t);
  const std::optional<MeasuredVector> measured = ensemble_.initialPositionEstimate(t, velocity);
  const core::Vector3 place = measured ? measured->value() : targets.vessel.position;
  targets.vehicle = {place + track_.lastOrientation() * attachment_, velocity};
  if (measured)
    targets.vehicle_covariance = measured->covariance();
}

core::Matrix3 ObservedVehicleEnd::positionCovariance(const EndTargets& targets) const
{
  const double variance = navigation_.position_stddev * navigation_.position_stddev;
  return targets.vehicle_covariance.value_or(variance * core::Matrix3::Identity());
}

core::SolveReport ObservedVehicleEnd::findStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                                const EndTargets& targets, VehicleInitialization& start) const
{
  return ensemble_.initialize(simulation.steady_solver, simulation.model, ends, positionCovariance(targets),
                              thrustInWorld(), start);
}

bool ObservedVehicleEnd::completeStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                       const EndTargets& targets, VehicleInitialization& start) const
{
  return ensemble_.findMembers(simulation.steady_solver, simulation.model, ends, positionCovariance(targets),
                               targets.vessel_velocity_stddev, thrustInWorld(), start);
}

core::CableModel ObservedVehicleEnd::modelAtRest(const core::CableModel& model,
                                                 const VehicleInitialization& start) const
{
  return ensemble_.modelWithInitialForces(model, start, thrustInWorld());
}

void ObservedVehicleEnd::begin(const VehicleInitialization& start, const EndTargets& targets,
                               CableSimulation& simulation)
{
  ensemble_.begin(start, simulation.state.time - targets.vehicle_age, simulation);
}

core::SolveReport ObservedVehicleEnd::advance(core::BoundaryConditions& paths, const EndTargets& targets, double t,
                                              CableSimulation& simulation)
{
  paths.vehicle_thrust = thrust_.at(t);
  return ensemble_.advance(simulation.model, paths, targets.vessel_stddev, targets.vessel_error_rate, t,
                           simulation.state);
}

void ObservedVehicleEnd::moveObstacle(std::size_t k, const CableSimulation& simulation)
{
  ensemble_.moveObstacle(k, simulation.state.obstacles[k]);
}

void ObservedVehicleEnd::describe(CableSimulation& simulation, TetherEstimate& estimate) const
{
  const core::DeployedCable& cable = simulation.updatedCable();
  describeVehicle(cable, simulation.state, estimate);
  ensemble_.describe(cable, estimate);
}

Reason ObservedVehicleEnd::invalidReason(const TetherEstimate& e, const EndTargets& targets) const
{
  if (ensemble_.overdueTime(ensemble_.age(e.time)) > invalid_timeout_)
    return Reason::VEHICLE_STALE;
  const double stddev = largestTensionStddev(e) / working_load_;
  // The waves are still to come, and no alarm is wanted for what is missing of them.
  if (targets.is_vessel_ramping_up && stddev > navigation_.degraded_stddev)
    return Reason::SETTLING;
  const bool was_worthless = e.status == Status::INVALID && e.reasons.has(Reason::UNCERTAIN);
  const double most = (was_worthless ? BACK : 1.0) * navigation_.invalid_stddev;
  return stddev <= most ? Reason::NONE : Reason::UNCERTAIN;
}

Reason ObservedVehicleEnd::degradedReason(const TetherEstimate& e) const
{
  if (ensemble_.isInconsistent(e.time))
    return Reason::DISAGREEMENT;
  const bool thrust_is_late = thrust_.age(e.time).value_or(0.0) > pose_timeout_;
  if (thrust_is_late || ensemble_.overdueTime(ensemble_.age(e.time)) > pose_timeout_)
    return Reason::VEHICLE_STALE;
  const double most = (e.reasons.has(Reason::UNCERTAIN) ? BACK : 1.0) * navigation_.degraded_stddev;
  return largestTensionStddev(e) > most * working_load_ ? Reason::UNCERTAIN : Reason::NONE;
}

void ObservedVehicleEnd::prepareForecast(ForecastStart& start) const
{
  const EnsembleFilter& filter = ensemble_.filter();
  const MotionErrorFilter& error = filter.motionError();
  start.thrust = thrust_.at(start.t);
  start.attitude = ensemble_.attitude();
  start.unknown_force = filter.unknownForce();
  start.slow_force_covariance = error.covariance().block<3, 3>(MotionErrorFilter::SLOW, MotionErrorFilter::SLOW);
  start.members.reserve(ensemble_.members().size());
  for (int i = 0; i < ensemble_.members().size(); ++i)
    start.members.push_back({ensemble_.members().state(i),
                             error.means().col(i).segment<3>(MotionErrorFilter::SLOW),
                             error.means().col(i).segment<3>(MotionErrorFilter::FAST),
                             filter.loadCell().ratio(i, filter.parameters()(TENSION_BIAS, i),
                                                     filter.prior().stddev[TENSION_BIAS], start.t)});
}

bool ObservedVehicleEnd::isValid(const core::CableModel& model) const
{
  return track_.isValid() && thrust_.isValid() && ensemble_.isValid(model);
}

}  // namespace tether_monitor::monitor
