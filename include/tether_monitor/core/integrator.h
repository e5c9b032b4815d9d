#pragma once

#include "tether_monitor/core/cable_model.h"
#include "tether_monitor/core/cable_state.h"
#include "tether_monitor/core/end_path.h"
#include "tether_monitor/core/newton_options.h"
#include "tether_monitor/core/solve_report.h"

namespace tether_monitor::core
{
/**
 * One implicit time step of a tether whose two ends are held on given paths.
 *
 * Model: generalised-alpha in the form of Arnold & Brüls (2007), doi:10.1007/s11044-007-9084-0, (M12) of
 * doc/model.md: the equations of motion hold at the end of the step, so end forces are their residual there (M13),
 * second-order accurate. Newton's iteration with analytic tangent on the block-tridiagonal system.
 */
class GeneralizedAlpha
{
 public:
  /**
   * @param nodes             nodes of the model that will be stepped, >= 2. All memory is taken here.
   * @param spectral_radius   rho_inf [-], 0 <= rho_inf <= 1: numerical damping of unresolved motion; 1 is none.
   * @throws std::invalid_argument naming the argument.
   */
  explicit GeneralizedAlpha(int nodes, double spectral_radius = 0.6,
                            const NewtonOptions& options = NewtonOptions());

  /**
   * Steps `state` from state.time to state.time + h.
   *
   * @param h      step [s], > 0.
   * @param state  in and out; unchanged unless the report says converged.
   * @return       iterations of this step, status and residual.
   */
  SolveReport step(const CableModel& model, const EndPaths& ends, double h, CableState& state);

  /// Sets state.a and state.aux so that the equations of motion hold at state.time, for a motion that begins
  /// there.
  SolveReport initialiseAcceleration(const CableModel& model, const EndPaths& ends, CableState& state);

  const NewtonOptions& options() const { return options_; }

 private:
  void placeEnds(const EndPaths& ends);

  double alpha_m_, alpha_f_, beta_, gamma_;
  NewtonOptions options_;
  CableState trial_;
  NodeField residual_;
  BlockTridiagonal tangent_;
};

}  // namespace tether_monitor::core
