#pragma once

#include <vector>

#include "tether_monitor/core/assembly/end_body_condensation.h"

namespace tether_monitor::core
{
/**
 * Dynamic stiffness of a tether at its ends at a real Laplace variable sigma: all displacements grow as e^(sigma
 * t).
 *
 * Forces are those that a node must receive from outside, world axes [N/m]. Rows: force; columns: displacement.
 */
struct EndDynamicStiffness
{
  Matrix3 vehicle = Matrix3::Zero();   ///< at the vehicle end, the vessel end held; the vehicle included.
  Matrix3 tether = Matrix3::Zero();    ///< the same of the tether alone.
  Matrix3 transfer = Matrix3::Zero();  ///< at the vessel end for a displacement of the vehicle end.
  Matrix3 vessel = Matrix3::Zero();    ///< at the vessel end for its own displacement; the vehicle follows.
};

/**
 * Finds the EndDynamicStiffness of a tether in motion by block elimination: (E3) of doc/theory/estimation.md.
 *
 * The iteration matrix of a time step, with other weights, is the dynamic stiffness sigma^2 M + sigma C + K of the
 * equations of motion (M11) about a state; reduced to the ends it says all that a body there can feel.
 */
class EndDynamicStiffnessSolver
{
 public:
  /// @param nodes  of the models to come, >= 2. All memory is taken here.
  explicit EndDynamicStiffnessSolver(int nodes);

  /**
   * @param cable  with a held vessel end; without a simulated vehicle `vehicle` is that of the tether alone.
   * @param sigma  Laplace variable [1/s], > 0.
   * @return       false, and `stiffness` is unusable, if the matrix is singular.
   */
  bool solve(const DeployedCable& cable, const CableState& state, double sigma, EndDynamicStiffness& stiffness);
  /// The same for set-up and tests: allocates.
  bool solve(const CableModel& model, const CableState& state, double sigma, EndDynamicStiffness& stiffness);

 private:
  BlockTridiagonal tangent_;
  NodeField residual_;
  std::vector<NodeMatrix> columns_;
};

}  // namespace tether_monitor::core
