#pragma once

#include "tether_monitor/core/cable/end_trajectory.h"

namespace tether_monitor::monitor
{
/**
 * Spreads corrections of an extrapolated end over the interval of its measurements.
 *
 * When poses come more slowly than ticks, each new pose corrects an extrapolation. Made up within one tick, a
 * correction of centimetres would be a shock to a taut tether. This keeps the motion of the end continuous: the
 * correction becomes an offset that fades with the time between poses.
 */
class CorrectionBlender
{
 public:
  /**
   * The point that the model's end shall reach at time t.
   *
   * @param t              [s], increasing from call to call; else reset() first.
   * @param now            where the measurements say that the end is.
   * @param pose_time      time of the pose that this rests on [s].
   * @param pose_interval  time from the pose before to this one [s]; not longer than the last call is ago: no
   * offset.
   */
  core::EndMotion blend(double t, const core::EndMotion& now, double pose_time, double pose_interval);
  void reset() { started_ = false; }

  template <class Archive>
  void serialize(Archive& a)
  {
    a(started_, t_, pose_time_, last_, offset_);
  }

 private:
  bool started_ = false;
  double t_ = 0.0;
  double pose_time_ = 0.0;
  core::EndMotion last_;
  core::EndMotion offset_;
};

}  // namespace tether_monitor::monitor
