#pragma once

#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::core
{
/**
 * Lets a tether at rest in contact slip where friction does not hold it: steps it with its ends at rest until
 * nothing moves, up to a minute. Does nothing without contact, or where the ends move.
 *
 * @param state  a steady state of SteadyStateSolver, after initializeContact(); in and out, its time stays.
 * @return       how the stepping went; CONVERGED if there was nothing to do.
 */
SolveReport relaxFriction(const CableModel& model, CableState& state);

/**
 * Steady shape by motion, the paper's "solution setting": from a curve with its ends in uniform motion until no
 * point moves faster than 2 cm/s against them, or 10 cm/s after 1000 s. For tethers whose steady state Newton does
 * not find: a neutral slack one hardly has any.
 *
 * @param start  the curve to start from.
 * @param shape  out: unchanged unless the report says converged.
 */
SolveReport relaxDynamically(const CableModel& model, const SteadyEnds& ends, const NodeField& start,
                             NodeField& shape);

/**
 * The steady state by all means: SteadyStateSolver::solve(); if it fails, motion until nothing moves, and from
 * there again.
 *
 * @param shape  out: unchanged unless the report says converged.
 */
SolveReport findSteadyState(SteadyStateSolver& solver, const CableModel& model, const SteadyEnds& ends,
                            NodeField& shape);

}  // namespace tether_monitor::core
