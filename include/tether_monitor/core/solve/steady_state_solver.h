#pragma once

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/assembly/prescribed_ends.h"
#include "tether_monitor/core/base/newton_options.h"
#include "tether_monitor/core/base/solve_report.h"

namespace tether_monitor::core
{
/// Ends between which a steady state is wanted: both move with the same constant velocity. The vehicle end is
/// held, or free if the model has a body there, which then finds its own position, its axes those of the world.
struct SteadyEnds
{
  Vector3 vessel = Vector3::Zero();    ///< position of the vessel end [m].
  Vector3 vehicle = Vector3::Zero();   ///< position of the vehicle end [m].
  Vector3 velocity = Vector3::Zero();  ///< common velocity [m/s].
};

/// Speed of the ends below which a tether lies still and friction holds it [m/s].
constexpr double STANDSTILL = 1e-3;

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
 * Model: (M16) of doc/model.md. The overdamped motion D dq/dtau + R(q) = 0 with backward Euler steps that grow as
 * the residual falls and shrink when Newton fails: at first a shape flows downhill, at last this is Newton's
 * method on R = 0. Waves are taken away.
 *
 * Where a tether at rest touches a surface it stays as it came down, however little friction there is: what lies
 * on the seabed has no steady state of its own. relaxFriction() lets go what friction does not hold.
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

  /// Where the last search ended, found or not.
  const NodeField& lastShape() const { return trial_.q; }

 private:
  // The flow from trial_ to its end.
  SolveReport pseudoTransientContinuation(const CableModel& model);
  // One backward Euler step from start_; scale is 1 / dtau, 0 for Newton's method on R = 0.
  SolveReport pseudoTimeStep(const CableModel& model, double scale, const NewtonOptions& newton,
                             int& iterations_left);
  // Solves for the step, with pivoting where it does not go without.
  bool solve(const CableModel& model);
  ResidualSize assemble(const CableModel& model, double scale, const NewtonOptions& newton);

  SteadyStateOptions options_;
  CableState trial_;
  NodeField start_, residual_, start_residual_;
  BlockTridiagonal tangent_;
};

/// The curve from which SteadyStateSolver::solve() starts.
NodeField startingShape(const CableModel& model, const SteadyEnds& ends);

}  // namespace tether_monitor::core
