#pragma once

#include <optional>

#include "tether_monitor/monitor/forecast/forecast_actions.h"
#include "tether_monitor/monitor/forecast/forecast_start.h"
#include "tether_monitor/monitor/forecast/thrust_course.h"
#include "tether_monitor/monitor/forecast/winch_course.h"

namespace tether_monitor::monitor
{
/// How the ends of the tethers of a forecast may go on.
struct EndSamplers
{
  EndMotionSampler vessel;
  std::optional<EndMotionSampler> vehicle;  ///< where its motion is not simulated.
};

/// What one member of a forecast goes through: the motion of its ends, its unknown force, its thrust and its
/// winch, step by step, (F1), (F2), (F5), (F6) of doc/theory/forecast.md.
class MemberCourse
{
 public:
  static constexpr double STEP = 0.2;  ///< [s]

  /// What is given by reference must outlive it, but for the member. @param pull  of the tether on the vehicle at
  /// the beginning [N]. @param index  its number: chooses what is drawn.
  MemberCourse(const ForecastStart& start, const ForecastActions& actions, const EndSamplers& samplers,
               const core::RigidBody& body, const ForecastMember& member, const core::Vector3& pull, int index);

  /// From the member's state to the end of the next step at time t [s]. @param pull  as above, now.
  core::BoundaryConditions next(double t, const core::CableState& state, const core::Vector3& pull);

 private:
  core::EndTrajectory follow(const EndMotionSampler& sampler, EndMotionSampler::Course& course,
                             core::EndMotion& at, double from, double t);
  core::Vector3 unknownForce();

  const ForecastStart& start_;
  const ForecastActions& actions_;
  const EndSamplers& samplers_;
  const core::RigidBody& body_;
  RandomNumbers random_;
  EndMotionSampler::Course vessel_, vehicle_{};
  core::EndMotion vessel_end_, vehicle_end_;  // relative to the origin of the sea
  core::Vector3 slow_force_, fast_force_;     // [N]
  std::optional<ThrustCourse> reaction_;
  WinchCourse winch_;
};

}  // namespace tether_monitor::monitor
