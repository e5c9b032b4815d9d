#pragma once

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/assembly/end_body_condensation.h"
#include "tether_monitor/core/assembly/prescribed_ends.h"
#include "tether_monitor/core/base/newton_options.h"
#include "tether_monitor/core/base/solve_report.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/cable/end_trajectory.h"

namespace tether_monitor::core
{
/**
 * One implicit time step of a tether with all that moves with it: ends that are held on given paths or fixed to
 * simulated bodies, obstacles that it pushes, contact, pay-out.
 *
 * Model: generalised-alpha in the form of Arnold & Brüls (2007), doi:10.1007/s11044-007-9084-0, (M12) of
 * doc/model.md: the equations of motion hold at the end of the step, so end forces are their residual there (M13),
 * second-order accurate; rotations by the exponential map. Newton's iteration with analytic tangent on the
 * block-tridiagonal system.
 */
class GeneralizedAlpha
{
 public:
  /**
   * @param model             that will be stepped, or one like it. All memory is taken here.
   * @param spectral_radius   rho_inf [-], 0 <= rho_inf <= 1: numerical damping of unresolved motion; 1 is none.
   * @throws std::invalid_argument naming the argument.
   */
  explicit GeneralizedAlpha(const CableModel& model, double spectral_radius = 0.6,
                            const NewtonOptions& options = NewtonOptions());

  /**
   * Steps `state` from state.time to state.time + h.
   *
   * @param model  takes the deployed length of the end of the step, if it is told.
   * @param h      step [s], > 0.
   * @param state  in and out; unchanged unless the report says converged. After initializeContact().
   * @return       iterations of this step, status and residual.
   */
  SolveReport step(CableModel& model, const BoundaryConditions& ends, double h, CableState& state);

  /// Sets all accelerations so that the equations of motion hold at state.time, for a motion that begins there.
  SolveReport initialiseAcceleration(CableModel& model, const BoundaryConditions& ends, CableState& state);

  /// Takes memory for the obstacles of `model`, after they changed.
  void prepareObstacles(const CableModel& model);
  const NewtonOptions& options() const { return options_; }

 private:
  // A body that moves with the tether: how it couples, and its rotation over the step.
  struct RotationIncrement
  {
    CondensedBody coupling;
    Vector3 rotation_increment = Vector3::Zero();
  };

  // The residual alone, or with one of the tangents of TangentKind.
  enum class AssemblyMode
  {
    RESIDUAL,
    SYMMETRIC,
    COMPLETE
  };

  void predict(const CableModel& model, const BoundaryConditions& ends, double h, const CableState& state);

  // Residual and iteration matrix of everything at the trial state, ready to be solved.
  ResidualSize assemble(const CableModel& model, const BoundaryConditions& ends, const TangentWeights& weights,
                        AssemblyMode wanted);
  bool solve();
  void correct(const CableModel& model, const TangentWeights& weights, double scale, const CableState& state);

  double alpha_m_, alpha_f_, beta_, gamma_;
  NewtonOptions options_;
  CableState trial_;
  NodeField residual_;
  BlockTridiagonal tangent_;
  const kernel::Kernel* kernel_ = nullptr;
  RotationIncrement vessel_, vehicle_;
  BorderedSystem bordered_;
  std::vector<int> movable_obstacles_;  // obstacles with a mass
};

}  // namespace tether_monitor::core
