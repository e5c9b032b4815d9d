#pragma once

#include "tether_monitor/core/assembly/prescribed_ends.h"
#include "tether_monitor/core/base/newton_options.h"
#include "tether_monitor/core/base/solve_report.h"
#include "tether_monitor/core/solve/steady_ends.h"

namespace tether_monitor::core
{
/// Bounds of the search for a steady state.
struct SteadyStateOptions
{
  /// Newton iterations of one search, >= 1; a failed search is repeated by way of a stiffer tether.
  int max_iterations = 1000;
  NewtonOptions newton{1e-8, 30};
};

/**
 * Steady shape of a tether from a held vessel end to a held vehicle end or to a body that hangs there ("solution
 * setting"), from any positions of the ends.
 *
 * Model: (M16) of doc/model.md, pseudo-transient continuation: the overdamped motion D dq/dtau + R(q) = 0 with
 * backward Euler steps that grow as the residual falls and shrink when Newton fails: at first a shape moves
 * downhill, at last this is Newton's method on R = 0. Waves are taken away.
 *
 * Where a tether at rest touches a surface it stays as it came down, however little friction there is: what lies
 * on the seabed has no steady state of its own. settleFriction() lets go what friction does not hold.
 */
class SteadyStateSolver
{
 public:
  /// @param nodes  nodes of the models to be solved, >= 2.
  explicit SteadyStateSolver(int nodes, const SteadyStateOptions& options = SteadyStateOptions());

  /**
   * @param shape  out: the steady coordinates; unchanged unless the report says converged.
   * @return       status; FOLDED_EQUILIBRIUM if the equilibrium found is folded. Never throws.
   */
  SolveReport solve(const CableModel& model, const SteadyEnds& ends, NodeField& shape);

  /// As solve(), starting from the curve in `shape`, whose ends are moved to `ends`.
  SolveReport solveFrom(const CableModel& model, const SteadyEnds& ends, NodeField& shape);

  /**
   * Lets a tether at rest in contact slip where friction does not hold it, without inertia: the same continuation
   * with Coulomb's friction, its springs tied anew after every step.
   *
   * @param state  a steady state after initializeContact(), its vessel end on `ends`; in and out: coordinates and
   *               friction springs in equilibrium. Unchanged unless the report says converged.
   */
  SolveReport settleFriction(const CableModel& model, const SteadyEnds& ends, CableState& state);

  /// Where the last search ended, found or not.
  const NodeField& lastShape() const { return trial_.q; }

 private:
  // What one search works with.
  struct Search
  {
    explicit Search(const CableModel& model, const SteadyEnds& ends);

    DeployedCable cable;
    NodeField start;           // of a pseudo-time step
    NodeField start_residual;  // of an iteration
  };

  NodeField firstGuess(const DeployedCable& cable, const SteadyEnds& ends);
  SolveReport searchByStiffening(const SteadyEnds& ends, Search& search, NodeField& shape);
  SolveReport searchByObstacleStiffness(const CableModel& model, const SteadyEnds& ends, NodeField& shape);
  SolveReport searchFrom(const SteadyEnds& ends, Search& search, NodeField& shape);
  // From trial_ to the end.
  SolveReport pseudoTransientContinuation(Search& search);
  // One backward Euler step from search.start; scale is 1 / dtau, 0 for Newton's method on R = 0.
  SolveReport pseudoTimeStep(double scale, const NewtonOptions& newton, Search& search, int& iterations_left);
  // Solves for the step, with pivoting where it does not go without.
  bool solve(Search& search);
  ResidualSize assemble(double scale, const NewtonOptions& newton, const Search& search);

  SteadyStateOptions options_;
  CableState trial_;
  NodeField residual_;
  BlockTridiagonal tangent_;
};

}  // namespace tether_monitor::core
