#pragma once

#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::core
{
/// What a watch has seen.
struct RestReport
{
  SolveReport solve;         ///< CONVERGED: quiet for a minute; NOT_AT_REST, or how the stepping failed.
  bool was_at_rest = false;  ///< from the beginning.
  double watched = 0.0;      ///< [s]
};

/**
 * Watches whether a steady state is at rest: steps it with its ends in uniform motion until its end forces have
 * changed by less than 0.2 % of the larger (or of 0.1 % of the dry weight, if that is more) for a minute.
 *
 * @param velocity  of the ends [m/s].
 * @param longest   time to watch [s].
 * @param state     in and out: unchanged if it was at rest from the beginning, else as it moves in the end; its
 * time and the place of its ends stay.
 */
RestReport watchRest(const CableModel& model, const Vector3& velocity, double longest, CableState& state);

/**
 * Lets a tether at rest in contact slip where friction does not hold it, SteadyStateSolver::settleFriction(), and
 * watches that it rests; up to ten minutes. Does nothing without contact, or where the ends move.
 *
 * @param solver  of as many nodes as the model.
 * @param state   a steady state of SteadyStateSolver, after initializeContact(); in and out, its time stays.
 * @return        CONVERGED if it is at rest, or there was nothing to do; NOT_AT_REST: the state moves as it would.
 */
SolveReport settleContact(SteadyStateSolver& solver, const CableModel& model, const SteadyEnds& ends,
                          CableState& state);

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
 * @param shape  out: unchanged unless the report is usable; of a slack tether that hardly weighs anything, where
 * it drifts slowly (NOT_AT_REST).
 */
SolveReport findSteadyState(SteadyStateSolver& solver, const CableModel& model, const SteadyEnds& ends,
                            NodeField& shape);

}  // namespace tether_monitor::core
