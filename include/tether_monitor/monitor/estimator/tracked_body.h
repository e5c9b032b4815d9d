#pragma once

#include <optional>
#include <utility>

#include "tether_monitor/monitor/config/body_config.h"
#include "tether_monitor/monitor/measurements/correction_blender.h"
#include "tether_monitor/monitor/measurements/height_record.h"
#include "tether_monitor/monitor/measurements/measurements.h"
#include "tether_monitor/monitor/measurements/motion_buffer.h"
#include "tether_monitor/monitor/measurements/motion_plausibility.h"

namespace tether_monitor::monitor
{
/// A body on its measured motion: where the end of the tether on it is.
class TrackedBody
{
 public:
  /// @param longest_interval  of poses over which a correction is spread, and age of a height that completes a
  /// place [s].
  TrackedBody(const BodyConfig& body, double longest_interval);

  /**
   * Accepts what one message measured, all of it or nothing. A height or an attitude by itself is kept for the
   * next place; heights that come by themselves count more than those of places. A velocity that is not complete
   * is left out, and so is one that contradicts the positions. A position that no body gets to is refused until
   * others confirm it.
   *
   * @param pose,twist  null: none.
   */
  Rejection add(const PoseMeasurement* pose, const TwistMeasurement* twist);
  void clear();
  /// The end of the tether at time t [s], continuous from call to call. Calls in order of t.
  core::EndMotion attachmentMotion(double t);
  /// Direction of a clamp at time t [s] in world axes; zero: there is none.
  core::Vector3 clampDirection(double t) const;
  const MotionBuffer& track() const { return track_; }
  bool isValid() const { return track_.isValid() && heights_.isValid() && plausibility_.isValid(); }
  const MotionPlausibility& plausibility() const { return plausibility_; }
  /// True once after the body was found elsewhere: its motion begins anew.
  bool takeLeap() { return std::exchange(has_leapt_, false); }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(track_, heights_, blender_, plausibility_, has_leapt_);
  }

 private:
  Rejection check(const PoseMeasurement* pose, const TwistMeasurement* twist) const;
  bool isPart(const PoseMeasurement& pose) const { return pose.isHeight() || pose.isAttitude(); }
  std::optional<core::Vector3> completed(const PoseMeasurement& pose) const;
  Rejection checkPose(const PoseMeasurement& pose) const;
  void addPart(const PoseMeasurement& part);
  bool addPose(double t, const core::Vector3& position, const std::optional<Eigen::Quaterniond>& orientation);
  void addTwist(const TwistMeasurement& twist);

  BodyConfig body_;
  double longest_interval_;
  MotionBuffer track_;
  HeightRecord heights_;
  CorrectionBlender<core::Vector3> blender_;
  MotionPlausibility plausibility_;
  bool has_leapt_ = false;
};

}  // namespace tether_monitor::monitor
