#include "tether_monitor/monitor/estimator/tracked_body.h"

#include <algorithm>

namespace tether_monitor::monitor
{
TrackedBody::TrackedBody(const BodyConfig& body, double longest_interval)
  : body_(body), longest_interval_(longest_interval)
{
}

Rejection TrackedBody::check(const PoseMeasurement* pose, const TwistMeasurement* twist) const
{
  Rejection rejection = Rejection::NONE;
  if (pose && !pose->position.isComplete())
    return Rejection::NOT_MEASURED;
  if (pose)
    rejection =
        track_.checkPose(pose->t, pose->position.value(), pose->orientation.value_or(track_.lastOrientation()));
  if (rejection == Rejection::NONE && twist)
    rejection = track_.checkTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
  return rejection;
}

Rejection TrackedBody::add(const PoseMeasurement* pose, const TwistMeasurement* twist)
{
  const Rejection rejection = check(pose, twist);
  if (rejection != Rejection::NONE)
    return rejection;
  if (pose && !addPose(*pose))
    return Rejection::IMPLAUSIBLE;
  if (twist && twist->velocity.isComplete())
    addTwist(*twist);
  return Rejection::NONE;
}

bool TrackedBody::addPose(const PoseMeasurement& pose)
{
  using Verdict = MotionPlausibility::Verdict;
  const Verdict verdict = plausibility_.check(pose.t, pose.position.value(), track_);
  if (verdict == Verdict::DOUBTFUL)
    return false;
  if (!plausibility_.trustsVelocity())
    track_.clearRates();
  const Eigen::Quaterniond orientation = pose.orientation.value_or(track_.lastOrientation());
  if (verdict == Verdict::REACQUIRED)
  {
    track_.clear();
    blender_.reset();
    has_leapt_ = true;
  }
  track_.addPose(pose.t, pose.position.value(), orientation);
  return true;
}

void TrackedBody::addTwist(const TwistMeasurement& twist)
{
  if (track_.hasPose())
    plausibility_.compareVelocity(twist.t, track_.at(twist.t).position, twist.velocity.value(),
                                  track_.lastOrientation());
  if (plausibility_.trustsVelocity())
    track_.addTwist(twist.t, twist.velocity.value(), twist.angular_velocity);
  else
    track_.clearRates();
}

void TrackedBody::clear()
{
  track_.clear();
  blender_.reset();
  plausibility_.clear();
  has_leapt_ = false;
}

core::Vector3 TrackedBody::clampDirection(double t) const
{
  return monitor::clampDirection(body_, track_.at(t).orientation);
}

core::EndMotion TrackedBody::attachmentMotion(double t)
{
  const core::EndMotion now = track_.at(t).attachmentPoint(body_.attachment);
  const auto target = blender_.blend(t, {now.position, now.velocity}, t - track_.age(t),
                                     std::min(track_.poseInterval(t), longest_interval_));
  return {target.value, target.rate};
}

}  // namespace tether_monitor::monitor
