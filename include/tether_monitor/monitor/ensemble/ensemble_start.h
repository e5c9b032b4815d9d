#pragma once

#include <vector>

#include "tether_monitor/core/solve/steady_state_solver.h"
#include "tether_monitor/monitor/ensemble/motion_error_filter.h"
#include "tether_monitor/monitor/ensemble/tether_parameters.h"

namespace tether_monitor::monitor
{
/// A member to begin with: at rest in the flow, held by a force that nobody has told of.
struct MemberStart
{
  ParameterVector parameters = ParameterVector::Zero();
  core::NodeField shape;
  core::Vector3 force = core::Vector3::Zero();  ///< [N], world axes.
};

/// An ensemble to begin with.
struct EnsembleStart
{
  std::vector<MemberStart> members;
  double shear_depth = 1.0;  ///< to which the shear of the current reaches [m].
};

/// What it is looked for from.
struct EnsembleStartInputs
{
  core::SteadyEnds ends;              ///< with the measured place of the tether's end at the vehicle.
  core::Matrix3 position_covariance;  ///< of that place [m^2], positive definite.
  core::Vector3 velocity_stddev;      ///< of the common velocity [m/s].
  core::Vector3 thrust;               ///< that is known [N], world axes.
  UnknownForce force;
  std::uint64_t seed = 1;
};

/**
 * Members drawn from what is known beforehand, each at rest where measured place and unknown force make it
 * likeliest, and then what that tells of their parameters: the force that a member would need at the measured
 * place is a measurement of zero. Assimilated in four parts, for a tether is not linear (Emerick and Reynolds
 * 2013); (E8) of doc/theory/estimation.md.
 *
 * @param model  with the simulated vehicle.
 * @param shape  a steady one near by.
 * @return       false if more than a quarter of the members have no steady state; `start` is then unchanged.
 */
bool findEnsembleStart(const ParameterPrior& prior, int members, core::SteadyStateSolver& statics,
                       const core::CableModel& model, const EnsembleStartInputs& inputs,
                       const core::NodeField& shape, EnsembleStart& start);

}  // namespace tether_monitor::monitor
