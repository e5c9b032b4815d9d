#pragma once

#include <vector>

#include "tether_monitor/core/assembly/end_body_condensation.h"
#include "tether_monitor/core/assembly/prescribed_ends.h"
#include "tether_monitor/core/base/solve_report.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/cable/end_trajectory.h"

namespace tether_monitor::core
{
/**
 * The paper's scheme: three layers in time, a predictor with the nodes' own blocks of the mass matrix and
 * corrections that bring in the neighbours and the forces of the new layer.
 *
 * Model: (44)-(47) of Blintsov & Trunin (2020) after Abarbanel & Zwas, (M25) of doc/model.md. Explicit: a step
 * must stay below stableStep(). Axial waves make that some 0.1 ms for a steel tether.
 */
class AbarbanelZwas
{
 public:
  /// Largest c h / l [-] that does not grow, c^2 = EA / m, with both ends held and with a free end, for any number
  /// of corrections >= 1. The predictor alone bears 0.25.
  static constexpr double HELD_LIMIT = 0.119;
  static constexpr double FREE_LIMIT = 0.086;

  /**
   * @param model        that will be stepped, or one like it. All memory is taken here.
   * @param corrections  >= 0. One is the paper's and leaves natural frequencies 6 % too low; 8 solve the
   * consistent mass to 1e-4.
   * @throws std::invalid_argument naming the argument.
   */
  AbarbanelZwas(const CableModel& model, int corrections);

  /// Largest stable step [s] for a model, from the fastest wave in any element: axial, bending, contact, with what
  /// the axial damping takes off.
  static double stableStep(const DeployedCable& cable);
  double stableStep(const CableModel& model, const CableState& state);

  /// As GeneralizedAlpha::step(); `iterations` counts predictor and corrections. Fails only when numbers are not
  /// finite.
  SolveReport step(const CableModel& model, const BoundaryConditions& ends, double h, CableState& state);

  /// Accepts memory for the obstacles of `model`, after they changed.
  void prepareObstacles(const CableModel& model);

 private:
  // Residual at the trial layer; the blocks of the mass matrix too on the first call of a step.
  void assemble(const BoundaryConditions& ends, bool first);
  void beginLayer(double h, const CableState& state);
  void place(const BoundaryConditions& ends, double h, const CableState& state);
  void accept(CableState& state);

  int corrections_;
  DeployedCable cable_;
  CableState trial_;
  NodeField residual_;
  BlockTridiagonal mass_;
  std::vector<Eigen::PartialPivLU<NodeMatrix>> blocks_;
  CondensedEndBodies bodies_;
  BorderedSystem bordered_;
  std::vector<int> movable_obstacles_;
};

}  // namespace tether_monitor::core
