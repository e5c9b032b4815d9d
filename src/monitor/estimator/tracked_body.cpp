#include "tether_monitor/monitor/estimator/tracked_body.h"

#include <algorithm>

namespace tether_monitor::monitor
{
TrackedBody::TrackedBody(const BodyConfig& body, double longest_interval)
  : body_(body), longest_interval_(longest_interval)
{
}

std::optional<core::Vector3> TrackedBody::completed(const PoseMeasurement& pose) const
{
  core::Vector3 position = pose.position.value();
  if (!pose.position.isMeasured(0) || !pose.position.isMeasured(1))
    return std::nullopt;
  if (const std::optional<double> height = heights_.at(pose.t, longest_interval_))
    position.z() = *height;
  else if (!pose.position.isMeasured(2))
    return std::nullopt;
  return position;
}

Rejection TrackedBody::checkPose(const PoseMeasurement& pose) const
{
  if (pose.isHeight())
    return heights_.check(pose.t, pose.position.value().z());
  if (pose.isAttitude())
    return track_.checkAttitude(pose.t, *pose.orientation, pose.angular_velocity);
  const std::optional<core::Vector3> position = completed(pose);
  return position ? track_.checkPose(pose.t, *position, pose.orientation.value_or(track_.lastOrientation()))
                  : Rejection::NOT_MEASURED;
}

Rejection TrackedBody::check(const PoseMeasurement* pose, const TwistMeasurement* twist) const
{
  Rejection rejection = pose ? checkPose(*pose) : Rejection::NONE;
  if (rejection == Rejection::NONE && twist)
    rejection = track_.checkTwist(twist->t, twist->velocity.value(), twist->angular_velocity);
  return rejection;
}

Rejection TrackedBody::add(const PoseMeasurement* pose, const TwistMeasurement* twist)
{
  const Rejection rejection = check(pose, twist);
  if (rejection != Rejection::NONE)
    return rejection;
  if (pose && isPart(*pose))
    addPart(*pose);
  else if (pose && !addPose(pose->t, *completed(*pose), pose->orientation))
    return Rejection::IMPLAUSIBLE;
  if (twist && twist->velocity.isComplete())
    addTwist(*twist);
  return Rejection::NONE;
}

void TrackedBody::addPart(const PoseMeasurement& part)
{
  if (part.isHeight())
    heights_.add(part.t, part.position.value().z());
  else
    track_.addAttitude(part.t, *part.orientation, part.angular_velocity);
}

bool TrackedBody::addPose(double t, const core::Vector3& position,
                          const std::optional<Eigen::Quaterniond>& measured_orientation)
{
  using Verdict = MotionPlausibility::Verdict;
  const Verdict verdict = plausibility_.check(t, position, track_);
  if (verdict == Verdict::DOUBTFUL)
    return false;
  if (!plausibility_.trustsVelocity())
    track_.clearRates();
  const Eigen::Quaterniond orientation = measured_orientation.value_or(track_.orientationAt(t));
  if (verdict == Verdict::REACQUIRED)
  {
    track_.clear();
    blender_.reset();
    has_leapt_ = true;
  }
  track_.addPose(t, position, orientation);
  return true;
}

void TrackedBody::addTwist(const TwistMeasurement& twist)
{
  if (track_.hasPose())
    plausibility_.compareVelocity(twist.t, track_.at(twist.t).position, track_.extrapolation(twist.t),
                                  twist.velocity.value(), track_.lastOrientation());
  if (plausibility_.trustsVelocity())
    track_.addTwist(twist.t, twist.velocity.value(), twist.angular_velocity);
  else
    track_.clearRates();
}

void TrackedBody::clear()
{
  track_.clear();
  heights_.clear();
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
