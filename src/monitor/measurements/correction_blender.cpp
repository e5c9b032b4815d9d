#include "tether_monitor/monitor/measurements/correction_blender.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double FADING = 2.5;  // rate of fading times the interval of the poses [-]
}

core::EndMotion CorrectionBlender::blend(double t, const core::EndMotion& now, double pose_time,
                                         double pose_interval)
{
  const double dt = t - t_;
  core::EndMotion target = now;
  if (!started_ || !(dt > 0.0) || pose_interval <= 1.5 * dt)
  {
    offset_ = core::EndMotion();
  }
  else
  {
    if (pose_time != pose_time_)
    {
      offset_.position -= now.position - (last_.position + dt * last_.velocity);
      offset_.velocity -= now.velocity - last_.velocity;
    }
    // Critically damped fading.
    const double w = FADING / pose_interval;
    const double decay = std::exp(-w * dt);
    const core::Vector3 drive = offset_.velocity + w * offset_.position;
    offset_.position = decay * (offset_.position + dt * drive);
    offset_.velocity = decay * (offset_.velocity - w * dt * drive);
    target.position += offset_.position;
    target.velocity += offset_.velocity;
  }
  started_ = true;
  t_ = t;
  pose_time_ = pose_time;
  last_ = now;
  return target;
}

}  // namespace tether_monitor::monitor
