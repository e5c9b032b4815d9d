#include "tether_monitor/monitor/estimator/observed_vehicle_end.h"

#include <algorithm>

#include "tether_monitor/monitor/estimate/estimate_summary.h"

namespace tether_monitor::monitor
{
namespace
{
double largestTensionStddev(const TetherEstimate& e)
{
  return std::max(e.vessel_tension_stddev, e.vehicle_tension_stddev);
}
}  // namespace

ObservedVehicleEnd::ObservedVehicleEnd(const Config& config)
  : attachment_(config.vehicle.attachment),
    least_stddev_(config.vehicle.least_stddev),
    navigation_(config.navigation),
    pose_timeout_(config.pose_timeout),
    invalid_timeout_(config.invalid_timeout),
    working_load_(config.tether.working_load),
    observer_(config, config.elements + 1)
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
  if (pose)
    rejection =
        track_.checkPose(pose->t, pose->position.value(), pose->orientation.value_or(track_.lastOrientation()));
  if (pose && canBeReordered(rejection) && !pose->position.isEmpty())
    rejection = observer_.check(positionFix(*pose));
  if (canBeReordered(rejection) && twist)
    rejection = track_.checkTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
  if (twist && canBeReordered(rejection) && !twist->velocity.isEmpty())
    rejection = observer_.check(velocityFix(*twist));
  return canBeReordered(rejection) ? Rejection::NONE : rejection;
}

Rejection ObservedVehicleEnd::add(const PoseMeasurement* pose, const TwistMeasurement* twist)
{
  const Rejection rejection = check(pose, twist);
  if (rejection != Rejection::NONE)
    return rejection;
  if (pose)
  {
    const Rejection order =
        track_.addPose(pose->t, pose->position.value(), pose->orientation.value_or(track_.lastOrientation()));
    if (pose->orientation && order == Rejection::NONE)
      observer_.setAttitude(pose->orientation->normalized());
    if (!pose->position.isEmpty())
      observer_.add(positionFix(*pose));
  }
  if (twist)
  {
    track_.addTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
    if (!twist->velocity.isEmpty())
      observer_.add(velocityFix(*twist));
  }
  return Rejection::NONE;
}

void ObservedVehicleEnd::setThrust(double t, const core::Wrench& thrust)
{
  thrust_.add(t, thrust);
}

void ObservedVehicleEnd::clear()
{
  track_.clear();
  observer_.clear();
  thrust_.clear();
}

double ObservedVehicleEnd::overdue(double age) const
{
  return std::max(observer_.overdueTime(age), 0.0);
}

void ObservedVehicleEnd::aimAtStart(double t, EndTargets& targets)
{
  const core::Vector3& velocity = targets.vessel.velocity;
  targets.vehicle_age = observer_.measuredAge(t);
  const std::optional<MeasuredVector> measured = observer_.initialPositionEstimate(t, velocity);
  const core::Vector3 place = measured ? measured->value() : targets.vessel.position;
  targets.vehicle = {place + track_.lastOrientation() * attachment_, velocity};
  if (measured)
    targets.vehicle_covariance = measured->covariance();
}

core::SolveReport ObservedVehicleEnd::findStart(CableSimulation& simulation, const core::SteadyEnds& ends,
                                                const EndTargets& targets, VehicleInitialization& start) const
{
  const double variance = navigation_.position_stddev * navigation_.position_stddev;
  const core::Matrix3 covariance = targets.vehicle_covariance.value_or(variance * core::Matrix3::Identity());
  return observer_.initialize(simulation.steady_solver, simulation.model, ends, covariance,
                              targets.vessel_velocity_stddev, thrustInWorld(), start);
}

core::CableModel ObservedVehicleEnd::modelAtRest(const core::CableModel& model,
                                                 const VehicleInitialization& start) const
{
  return observer_.modelWithInitialForces(model, start, thrustInWorld());
}

void ObservedVehicleEnd::begin(const VehicleInitialization& start, const EndTargets& targets,
                               CableSimulation& simulation)
{
  const double measured_at = simulation.state.time - targets.vehicle_age;
  observer_.begin(simulation.model, start, measured_at, simulation.state);
}

core::SolveReport ObservedVehicleEnd::advance(core::BoundaryConditions& paths, const EndTargets& targets, double t,
                                              CableSimulation& simulation)
{
  paths.vehicle_thrust = thrust_.at(t);
  return observer_.advance(simulation.model, simulation.stepper, paths, targets.vessel_stddev,
                           targets.vessel_error_rate, t, simulation.state);
}

void ObservedVehicleEnd::moveObstacle(std::size_t k, const CableSimulation& simulation)
{
  observer_.moveObstacle(k, simulation.state.obstacles[k], simulation.state.time);
}

void ObservedVehicleEnd::describe(CableSimulation& simulation, TetherEstimate& estimate) const
{
  describeVehicle(simulation.updatedCable(), simulation.state, estimate);
  observer_.describe(estimate);
}

Reason ObservedVehicleEnd::invalidReason(const TetherEstimate& e, const EndTargets& targets) const
{
  if (observer_.overdueTime(observer_.age(e.time)) > invalid_timeout_)
    return Reason::VEHICLE_STALE;
  const double stddev = largestTensionStddev(e) / working_load_;
  // The waves are still to come, and no alarm is wanted for what is missing of them.
  if (targets.is_vessel_ramping_up && stddev > navigation_.degraded_stddev)
    return Reason::SETTLING;
  return stddev <= navigation_.invalid_stddev ? Reason::NONE : Reason::UNCERTAIN;
}

Reason ObservedVehicleEnd::degradedReason(const TetherEstimate& e) const
{
  if (observer_.exceedsTetherLength())
    return Reason::OUT_OF_RANGE;
  if (observer_.isInconsistent(e.time))
    return Reason::DISAGREEMENT;
  const bool thrust_is_late = thrust_.age(e.time).value_or(0.0) > pose_timeout_;
  if (thrust_is_late || observer_.overdueTime(observer_.age(e.time)) > pose_timeout_)
    return Reason::VEHICLE_STALE;
  return largestTensionStddev(e) > navigation_.degraded_stddev * working_load_ ? Reason::UNCERTAIN : Reason::NONE;
}

bool ObservedVehicleEnd::isValid(const core::CableModel& model) const
{
  return track_.isValid() && thrust_.isValid() && observer_.isValid(model);
}

}  // namespace tether_monitor::monitor
