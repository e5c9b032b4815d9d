#pragma once

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/solve/steady_state_solver.h"
#include "tether_monitor/monitor/ensemble/ensemble_start.h"

namespace tether_monitor::monitor
{
/// A steady state to begin with: where the vehicle is, and which unmodelled force keeps it there.
struct VehicleInitialization
{
  core::NodeField shape;
  core::Vector3 force = core::Vector3::Zero();  ///< [N], world axes.
  double cost = 0.0;                            ///< what is minimised [-]; three is what chance would give.
  core::Matrix3 measured_covariance = core::Matrix3::Identity();  ///< of the measured place [m^2].
  EnsembleStart ensemble;
};

/// What a start is looked for from.
struct InitializationInputs
{
  core::SteadyEnds ends;  ///< with the measured place of the tether's end at the vehicle, and the common velocity.
  core::Matrix3 position_covariance = core::Matrix3::Identity();  ///< of that place [m^2], positive definite.
  core::Vector3 thrust = core::Vector3::Zero();                   ///< that is known [N], world axes.
  core::Vector3 force_stddev = core::Vector3::Ones();  ///< of the force that is not known, of every axis [N], > 0.
};

/**
 * The likeliest steady state, given a measured place and a disturbance of unknown size: (E8) of
 * doc/theory/estimation.md.
 *
 * Minimises (distance from the measured place / its deviation)^2 + (force / its deviation)^2: over the force, from
 * a vehicle that hangs where the tether lets it, and with a vehicle held at the measured place; the better of the
 * two.
 *
 * @param model  with the simulated vehicle.
 * @param start  out: unchanged unless the report says converged.
 */
core::SolveReport findVehicleInitialization(core::SteadyStateSolver& statics, const core::CableModel& model,
                                            const InitializationInputs& inputs, VehicleInitialization& start);

}  // namespace tether_monitor::monitor
