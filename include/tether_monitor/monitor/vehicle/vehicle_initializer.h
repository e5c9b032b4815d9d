#pragma once

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::monitor
{
/// A steady state to begin with: where the vehicle is, and what force nobody told keeps it there.
struct VehicleInitialization
{
  core::NodeField shape;
  core::Vector3 force = core::Vector3::Zero();                    ///< [N], world axes.
  core::Matrix3 position_covariance = core::Matrix3::Identity();  ///< covariance of the position [m^2].
  double cost = 0.0;  ///< what is minimised [-]; three is what chance would give.
};

/**
 * The likeliest steady state, given a measured place and a disturbance of unknown size: (E8) of doc/estimation.md.
 *
 * Minimises (distance from the measured place / its deviation)^2 + (force / its deviation)^2: over the force, from
 * a vehicle that hangs where the tether lets it, and with a vehicle held at the measured place; the better of the
 * two.
 *
 * @param model         with the simulated vehicle.
 * @param ends          with the measured place of the tether's end at the vehicle, and the common velocity.
 * @param position_stddev  of that place [m].
 * @param thrust        that is told [N], world axes.
 * @param force_stddev  of the force that is not, of every axis [N].
 * @param start         out: unchanged unless the report says converged.
 */
core::SolveReport findVehicleInitialization(core::SteadyStateSolver& statics, const core::CableModel& model,
                                            const core::SteadyEnds& ends, double position_stddev,
                                            const core::Vector3& thrust, const core::Vector3& force_stddev,
                                            VehicleInitialization& start);

/**
 * What a velocity of the steady state that is not quite known makes of the force of a start.
 *
 * @param velocity_stddev  of the common velocity [m/s].
 * @return                 covariance of the force [N^2]; without the part of an axis for which there is no steady
 * state.
 */
core::Matrix3 forceCovarianceFromVelocity(core::SteadyStateSolver& statics, const core::CableModel& model,
                                          const core::SteadyEnds& ends, const core::Vector3& velocity_stddev,
                                          const VehicleInitialization& start);

}  // namespace tether_monitor::monitor
