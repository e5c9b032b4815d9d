#include <algorithm>
#include <cmath>

#include "tether_monitor/core/solve/dynamic_relaxation.h"
#include "tether_monitor/monitor/estimate/estimate_summary.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double NO_ORIENTATION = 1.0;  // standard deviation of an orientation that was not measured [rad]
constexpr double STARTING_PLACE = 0.1;  // standard deviations of a motion that was told [m, m/s]
constexpr double STARTING_SPEED = 0.2;

core::Vector3 orElse(const core::Vector3& told, double otherwise)
{
  core::Vector3 stddev = told;
  for (int i = 0; i < 3; ++i)
    if (!(stddev[i] > 0.0))
      stddev[i] = otherwise;
  return stddev;
}

core::Vector3 unmeasuredAsInfinite(core::Vector3 stddev)
{
  for (int i = 0; i < 3; ++i)
    if (stddev[i] >= VesselMotionFilter::UNMEASURED)
      stddev[i] = std::numeric_limits<double>::infinity();
  return stddev;
}

// Good, if only for a filter that puts late ones in their place.
bool hasPlace(Rejection rejection)
{
  return rejection == Rejection::NONE || rejection == Rejection::OUT_OF_ORDER;
}
}  // namespace

Rejection TetherEstimator::addVessel(const PoseMeasurement& m)
{
  if (!isVehicleObserved() && m.position_stddev.maxCoeff() >= VesselMotionFilter::UNMEASURED)
    return Rejection::NOT_MEASURED;
  const bool turns = !isVehicleObserved() || !(m.orientation_stddev > NO_ORIENTATION);
  const Eigen::Quaterniond orientation = turns ? m.orientation : vessel_.lastOrientation();
  const Rejection rejection = vessel_.addPose(m.t, m.position, orientation);
  if (!isVehicleObserved() || !hasPlace(rejection))
    return rejection;
  const core::Vector3 lever = orientation.normalized() * config_.vessel.attachment;
  return vessel_filter_.addPosition(m.t, m.position + lever,
                                    orElse(m.position_stddev, config_.vessel.position_stddev.value_or(0.0)));
}

Rejection TetherEstimator::addVessel(const TwistMeasurement& m)
{
  const Rejection rejection = vessel_.addTwist(m.t, m.velocity, m.angular_velocity);
  if (!isVehicleObserved() || !hasPlace(rejection))
    return rejection;
  const core::Vector3 lever = vessel_.lastOrientation() * config_.vessel.attachment;
  return vessel_filter_.addVelocity(m.t, m.velocity + m.angular_velocity.cross(lever),
                                    orElse(m.velocity_stddev, config_.vessel.velocity_stddev.value_or(0.0)));
}

Rejection TetherEstimator::addVehicle(const PoseMeasurement& m)
{
  if (!isVehicleObserved() && m.position_stddev.maxCoeff() >= VesselMotionFilter::UNMEASURED)
    return Rejection::NOT_MEASURED;
  const bool turns = !isVehicleObserved() || !(m.orientation_stddev > NO_ORIENTATION);
  const Rejection rejection =
      vehicle_.addPose(m.t, m.position, turns ? m.orientation : vehicle_.lastOrientation());
  if (!isVehicleObserved() || !hasPlace(rejection))
    return rejection;
  if (turns && rejection == Rejection::NONE)
    observer_.setAttitude(m.orientation.normalized());
  const core::Vector3 stddev = unmeasuredAsInfinite(orElse(m.position_stddev, config_.navigation.position_stddev));
  if (!(stddev.minCoeff() < VesselMotionFilter::UNMEASURED))
    return Rejection::NONE;  // an attitude alone
  return observer_.add({m.t - config_.navigation.latency, VehicleMeasurement::Kind::POSITION, m.position, stddev});
}

Rejection TetherEstimator::addVehicle(const TwistMeasurement& m)
{
  const Rejection rejection = vehicle_.addTwist(m.t, m.velocity, m.angular_velocity);
  if (!isVehicleObserved() || !hasPlace(rejection))
    return rejection;
  const core::Vector3 stddev = unmeasuredAsInfinite(orElse(m.velocity_stddev, config_.navigation.velocity_stddev));
  return observer_.add({m.t - config_.navigation.latency, VehicleMeasurement::Kind::VELOCITY, m.velocity, stddev});
}

void TetherEstimator::setInitialVesselMotion(double t, const BodyState& vessel)
{
  vessel_filter_.start(t, vessel.attachmentPoint(config_.vessel.attachment), STARTING_PLACE, STARTING_SPEED);
}

double TetherEstimator::observedAge(double t) const
{
  return settled_ ? observer_.age(t) : observer_.measuredAge(t);
}

bool TetherEstimator::canBegin(double t) const
{
  if (!isVehicleObserved())
    return vessel_.hasPose() && (isVehicleFree() || vehicle_.hasPose());
  return vessel_filter_.isReady(t) && observer_.isReady(t);
}

void TetherEstimator::aimAtObserved(double t, EndTargets& targets)
{
  const VesselMotionFilter::Motion vessel = vessel_filter_.blend(t);
  targets.vessel = vessel.end;
  targets.vessel_age = vessel_filter_.age(t);
  targets.vessel_stddev = vessel.position_stddev;
  targets.vessel_error_rate = VesselMotionFilter::errorRate(vessel);
  targets.vehicle_age = observedAge(t);
  if (settled_)
    return;
  // A steady state has no waves: it begins on the vessel's way and fades into its motion.
  targets.vessel = vessel_filter_.estimateTrack(t);
  vessel_filter_.startBlending(t, targets.vessel);
  const core::Vector3& velocity = targets.vessel.velocity;
  const core::Vector3 place = observer_.initialPositionEstimate(t, velocity).value_or(targets.vessel.position);
  targets.vehicle = {place + vehicle_.lastOrientation() * config_.vehicle.attachment, velocity};
}

core::SolveReport TetherEstimator::initialize(const core::SteadyEnds& steady, core::NodeField& shape)
{
  if (isVehicleObserved())
    return observer_.initialize(statics_, model_, steady, vessel_filter_.trackVelocityStddev(),
                                vehicle_.lastOrientation() * thrust_.force, shape);
  return core::findSteadyState(statics_, model_, steady, shape);
}

core::SolveReport TetherEstimator::step(const core::BoundaryConditions& paths, const EndTargets& ends, double t)
{
  if (isVehicleObserved())
    return observer_.advance(model_, stepper_, paths, ends.vessel_stddev, ends.vessel_error_rate, t, state_);
  return stepper_.advance(model_, paths, t, state_);
}

double TetherEstimator::tensionStddev() const
{
  return std::max(estimate_.vessel_tension_stddev, estimate_.vehicle_tension_stddev);
}

// What makes the numbers of an observed vehicle worthless, though it coasts on.
Reason TetherEstimator::lackOf(double t) const
{
  if (!isVehicleObserved())
    return Reason::NONE;
  if (observer_.overdueTime(observedAge(t)) > config_.invalid_timeout)
    return Reason::VEHICLE_STALE;
  const double stddev = tensionStddev() / config_.tether.working_load;
  // The waves are still to come, and nobody needs an alarm for what is missing of them.
  if (vessel_filter_.isRampingUp(t) && stddev > config_.navigation.degraded_stddev)
    return Reason::SETTLING;
  return stddev <= config_.navigation.invalid_stddev ? Reason::NONE : Reason::UNCERTAIN;
}

// What makes them doubtful.
Reason TetherEstimator::doubt(double t) const
{
  if (observer_.exceedsTetherLength())
    return Reason::OUT_OF_RANGE;
  if (observer_.isInconsistent(t))
    return Reason::DISAGREEMENT;
  if (observer_.overdueTime(observedAge(t)) > config_.pose_timeout)
    return Reason::VEHICLE_STALE;
  return tensionStddev() > config_.navigation.degraded_stddev * config_.tether.working_load ? Reason::UNCERTAIN
                                                                                            : Reason::NONE;
}

const TetherEstimate& TetherEstimator::withhold(Reason reason)
{
  invalidate(reason, estimate_);
  alarms_changed_ = alarms_.update(estimate_);
  return estimate_;
}

}  // namespace tether_monitor::monitor
