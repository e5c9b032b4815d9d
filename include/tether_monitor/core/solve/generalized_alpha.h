#pragma once

#include "tether_monitor/core/assembly/end_body_condensation.h"
#include "tether_monitor/core/assembly/prescribed_ends.h"
#include "tether_monitor/core/base/solve_report.h"

namespace tether_monitor::core
{
/**
 * One implicit time step of a tether with all that moves with it: ends that are held on given trajectories or
 * fixed to simulated bodies, movable obstacles, contact, pay-out.
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
   * @param h      step [s], > 0.
   * @param state  in and out, its deployment included; unchanged unless the report says converged. After
   *               initializeContact().
   * @return       iterations of this step, status and residual.
   */
  SolveReport step(const CableModel& model, const BoundaryConditions& ends, double h, CableState& state);

  /// Sets all accelerations so that the equations of motion hold at state.time, for a motion that begins there.
  SolveReport initializeAcceleration(const CableModel& model, const BoundaryConditions& ends, CableState& state);

  /// Accepts memory for the obstacles of `model`, after they changed.
  void prepareObstacles(const CableModel& model);
  const NewtonOptions& options() const { return options_; }

 private:
  // The residual alone, or with one of the tangents of TangentKind.
  enum class AssemblyMode
  {
    RESIDUAL,
    SYMMETRIC,
    COMPLETE
  };

  void predict(const CableModel& model, const BoundaryConditions& ends, double h, const CableState& state);
  template <typename Value>
  void predictAcceleration(const Value& a, const Value& from_algorithmic, double growth, Value& to_a,
                           Value& to_algorithmic) const;
  void predictAttitude(const AttitudeState& from, double growth, double h, AttitudeState& to, Vector3& rotation);
  void predictObstacles(const CableState& state, double growth, double h);

  // Residual and iteration matrix of everything at the trial state, ready to be solved.
  ResidualSize assemble(const BoundaryConditions& ends, const TangentWeights& weights, AssemblyMode mode);
  bool solve();
  void correct(const TangentWeights& weights, double scale, const CableState& state);
  void accept(int iterations, CableState& state);

  double alpha_m_, alpha_f_, beta_, gamma_;
  NewtonOptions options_;
  DeployedCable cable_;  // at the trial state
  CableState trial_;
  NodeField residual_;
  BlockTridiagonal tangent_;
  CondensedEndBodies bodies_;
  Vector3 vessel_rotation_ = Vector3::Zero(), vehicle_rotation_ = Vector3::Zero();  // increments over the step
  BorderedSystem bordered_;
  std::vector<int> movable_obstacles_;  // those with a mass
};

}  // namespace tether_monitor::core
