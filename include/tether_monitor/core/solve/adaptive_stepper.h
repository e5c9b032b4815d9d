#pragma once

#include <variant>

#include "tether_monitor/core/solve/abarbanel_zwas.h"
#include "tether_monitor/core/solve/generalized_alpha.h"

namespace tether_monitor::core
{
/// Time schemes.
enum class Scheme
{
  GENERALIZED_ALPHA,  ///< implicit, (M12).
  ABARBANEL_ZWAS      ///< the paper's, explicit, (M25).
};

/// Bounds of the automatic step control.
struct StepperOptions
{
  double step = 0.05;            ///< [s], > 0: largest step.
  double spectral_radius = 0.6;  ///< rho_inf [-], 0..1.
  int max_halvings = 10;         ///< >= 0: smallest step is step / 2^max_halvings.
  int max_iterations = 400;  ///< >= 1: Newton iterations that one advance() may spend for each full step it has
                             ///< to make.
  NewtonOptions newton;
  Scheme scheme = Scheme::GENERALIZED_ALPHA;
  int corrections = 8;   ///< of ABARBANEL_ZWAS, 0..100.
  double courant = 0.9;  ///< its step over the stable one [-], 0 < courant <= 1.
};

/// Every bound of StepperOptions that `options` violates, one sentence each.
std::vector<std::string> validate(const StepperOptions& options);

/**
 * Advances a tether over any stretch of time with steps that halve when Newton's iteration fails and grow again
 * after.
 *
 * A failed step leaves no trace: the state before it is kept. The cost of a call is bounded by StepperOptions.
 * Allocates only in the constructor.
 */
class AdaptiveStepper
{
 public:
  /// @throws std::invalid_argument listing violated bounds.
  /// @param model  that will be stepped, or one like it.
  AdaptiveStepper(const CableModel& model, const StepperOptions& options);

  /**
   * Steps `state` to time t_end.
   *
   * @param ends   trajectories of the held ends, valid from state.time to t_end.
   * @param t_end  [s]; not before state.time (equal: nothing happens).
   * @param state  in and out; on failure the last state that converged, at its own time.
   * @return       sums over the call; ITERATION_LIMIT or the failure of the smallest step if t_end was not
   * reached; ITERATION_LIMIT at once if t_end is more than a million full steps away.
   */
  SolveReport advance(const CableModel& model, const BoundaryConditions& ends, double t_end, CableState& state);

  /// The forces have changed at once: the next step is the shortest, and goes on from no acceleration of before.
  void expectShock(CableState& state) const;

  /// Accepts memory for the obstacles of `model`, after they changed.
  void prepareObstacles(const CableModel& model);
  const StepperOptions& options() const { return options_; }

 private:
  using TimeIntegrator = std::variant<GeneralizedAlpha, AbarbanelZwas>;

  static TimeIntegrator makeIntegrator(const CableModel& model, const StepperOptions& options);
  SolveReport step(const CableModel& model, const BoundaryConditions& ends, double h, CableState& state);
  double largestStep(const CableModel& model, const CableState& state);
  bool isExplicit() const { return std::holds_alternative<AbarbanelZwas>(integrator_); }

  StepperOptions options_;
  TimeIntegrator integrator_;
};

}  // namespace tether_monitor::core
