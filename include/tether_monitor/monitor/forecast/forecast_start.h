#pragma once

#include <optional>
#include <vector>

#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/monitor/ensemble/motion_error_filter.h"
#include "tether_monitor/monitor/forecast/end_motion_predictor.h"
#include "tether_monitor/monitor/forecast/thrust_reaction.h"
#include "tether_monitor/monitor/forecast/vessel_plan.h"
#include "tether_monitor/monitor/forecast/winch_reaction.h"

namespace tether_monitor::monitor
{
/// One tether that goes on, and the unknown force on its vehicle [N].
struct ForecastMember
{
  core::CableState state;
  core::Vector3 slow_force = core::Vector3::Zero(), fast_force = core::Vector3::Zero();
  double tension_ratio = 1.0;  ///< measured over that of its state, (F7).
};

/// All that a forecast begins with, copied: the estimate goes on meanwhile.
struct ForecastStart
{
  double t = 0.0;  ///< [s]
  std::optional<core::CableModel> model;
  core::StepperOptions options;
  std::vector<ForecastMember> members;                 ///< at least one.
  UnknownForce unknown_force{0.0, 3600.0, 0.0, 15.0};  ///< on the vehicle: what comes on top of the members' own.
  core::Matrix3 slow_force_covariance = core::Matrix3::Zero();  ///< of it, for given parameters.
  core::Wrench thrust;                                          ///< on the vehicle, body axes.
  std::optional<ThrustReaction> reaction;      ///< of a vehicle whose thrust is reported; none: held.
  double max_thrust = 0.0;                     ///< that can be [N].
  std::optional<Eigen::Quaterniond> attitude;  ///< that the vehicle is held in.
  EndMotionPredictor vessel;
  std::optional<EndMotionPredictor> vehicle;  ///< of a vehicle whose end is moved.
  bool has_winch = false;                     ///< something reports the deployed length.
  double payout_rate = 0.0;                   ///< of the moment [m/s]
  WinchReaction winch;                        ///< how it has worked.
  VesselPlan plan;                            ///< where the vessel is meant to go.
  std::optional<PayoutPlan> payout_plan;      ///< what the winch is meant to do.
};

}  // namespace tether_monitor::monitor
