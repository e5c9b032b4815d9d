#include "tether_monitor/monitor/estimator/filtered_vessel_end.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double INITIAL_POSITION_STDDEV = 0.1;  // of a motion that is given [m]
constexpr double INITIAL_VELOCITY_STDDEV = 0.2;  // likewise [m/s]

}  // namespace

Eigen::Quaterniond FilteredVesselEnd::orientationOf(const PoseMeasurement* pose) const
{
  if (pose && pose->orientation)
    return *pose->orientation;
  return pose ? track_.orientationAt(pose->t) : track_.lastOrientation();
}

MeasuredVector FilteredVesselEnd::attachmentPosition(const PoseMeasurement& pose) const
{
  const core::Vector3 lever = orientationOf(&pose).normalized() * body_.attachment;
  const MeasuredVector position = pose.position.at(pose.position.value() + lever);
  const MeasuredVector specified =
      body_.position_stddev ? position.withDefaultStddev(*body_.position_stddev) : position;
  return specified.withLeastStddev(body_.least_stddev);
}

MeasuredVector FilteredVesselEnd::attachmentVelocity(const TwistMeasurement& twist,
                                                     const Eigen::Quaterniond& orientation) const
{
  const core::Vector3 lever = orientation.normalized() * body_.attachment;
  const MeasuredVector velocity = twist.velocity.at(twist.velocity.value() + twist.angular_velocity.cross(lever));
  return body_.velocity_stddev ? velocity.withDefaultStddev(*body_.velocity_stddev) : velocity;
}

Rejection FilteredVesselEnd::check(const PoseMeasurement* pose, const TwistMeasurement* twist) const
{
  Rejection rejection = Rejection::NONE;
  if (pose && pose->isAttitude())
    return track_.checkAttitude(pose->t, *pose->orientation, pose->angular_velocity);
  if (pose)
    rejection = track_.checkPose(pose->t, pose->position.value(), orientationOf(pose));
  if (pose && canBeReordered(rejection))
    rejection = filter_.checkPosition(pose->t, attachmentPosition(*pose));
  if (canBeReordered(rejection) && twist)
    rejection = track_.checkTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
  if (twist && canBeReordered(rejection))
    rejection = filter_.checkVelocity(twist->t, attachmentVelocity(*twist, orientationOf(pose)));
  return canBeReordered(rejection) ? Rejection::NONE : rejection;
}

Rejection FilteredVesselEnd::add(const PoseMeasurement* pose, const TwistMeasurement* twist)
{
  const Rejection rejection = check(pose, twist);
  if (rejection != Rejection::NONE)
    return rejection;
  if (pose && pose->isAttitude())
    return track_.addAttitude(pose->t, *pose->orientation, pose->angular_velocity);
  if (pose)
  {
    const MeasuredVector position = attachmentPosition(*pose);
    if (pose->position.isComplete() && pose->t > whole_.lastPoseTime())
    {
      plausibility_.watch(pose->t, pose->position.value(), whole_);
      whole_.addPose(pose->t, pose->position.value(), orientationOf(pose));
    }
    track_.addPose(pose->t, pose->position.value(), orientationOf(pose));
    filter_.addPosition(pose->t, position);
  }
  if (twist)
  {
    const MeasuredVector velocity = attachmentVelocity(*twist, track_.lastOrientation());
    if (velocity.isComplete() && filter_.hasPosition())
      plausibility_.compareVelocity(twist->t, filter_.at(twist->t).end.position, track_.extrapolation(twist->t),
                                    velocity.value(), track_.lastOrientation());
    if (!plausibility_.trustsVelocity())
      return Rejection::NONE;
    track_.addTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
    filter_.addVelocity(twist->t, velocity);
  }
  return Rejection::NONE;
}

std::optional<BodyState> FilteredVesselEnd::bodyAt(double t) const
{
  if (!filter_.hasPosition())
    return std::nullopt;
  const core::EndMotion end = filter_.at(t).end;
  const Eigen::Quaterniond orientation = track_.orientationAt(t);
  return BodyState{end.position - orientation * body_.attachment, orientation, end.velocity,
                   core::Vector3::Zero()};
}

void FilteredVesselEnd::setInitialMotion(double t, const BodyState& vessel)
{
  filter_.start(t, vessel.attachmentPoint(body_.attachment), INITIAL_POSITION_STDDEV, INITIAL_VELOCITY_STDDEV);
}

void FilteredVesselEnd::clear()
{
  track_.clear();
  whole_.clear();
  filter_.clear();
  plausibility_.clear();
}

void FilteredVesselEnd::aim(double t, EndTargets& targets)
{
  const VesselMotionFilter::Motion vessel = filter_.blend(t);
  targets.vessel = vessel.end;
  if (body_.clamped)
    targets.clamps.vessel = clampDirection(body_, track_.at(t).orientation);
  targets.vessel_age = age(t);
  targets.vessel_stddev = vessel.position_stddev;
  targets.vessel_error_rate = VesselMotionFilter::errorRate(vessel);
  targets.vessel_velocity_stddev = filter_.trackVelocityStddev();
  targets.is_vessel_ramping_up = filter_.isRampingUp(t);
}

void FilteredVesselEnd::aimAtStart(double t, EndTargets& targets)
{
  aim(t, targets);
  targets.vessel = filter_.estimateTrack(t);
  targets.vessel_velocity_stddev = filter_.trackVelocityStddev();
  filter_.startBlending(t, targets.vessel);
  targets.is_vessel_ramping_up = filter_.isRampingUp(t);
}

}  // namespace tether_monitor::monitor
