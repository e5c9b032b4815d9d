#pragma once

namespace tether_monitor::core
{
/// How a solver ended. Solvers report; they never throw.
enum class SolveStatus
{
  CONVERGED,           ///< The residual is below its tolerance.
  NOT_CONVERGED,       ///< The iterations ran out or the residual stopped falling.
  SINGULAR,            ///< The iteration matrix could not be factorised, or a number was not finite.
  ITERATION_LIMIT,     ///< The bounded number of steps or iterations was used up before the end was reached.
  FOLDED_EQUILIBRIUM,  ///< An equilibrium was found that no tether takes: an element is folded.
  NOT_AT_REST          ///< What was found as a steady state still moves.
};

/// Words for a SolveStatus.
constexpr const char* describe(SolveStatus status)
{
  switch (status)
  {
    case SolveStatus::CONVERGED:
      return "converged";
    case SolveStatus::NOT_CONVERGED:
      return "not converged";
    case SolveStatus::SINGULAR:
      return "singular or not finite";
    case SolveStatus::ITERATION_LIMIT:
      return "iteration budget spent";
    case SolveStatus::FOLDED_EQUILIBRIUM:
      return "folded equilibrium";
    case SolveStatus::NOT_AT_REST:
      return "does not come to rest";
  }
  return "unknown";
}

/// Outcome and cost of a solve.
struct SolveReport
{
  SolveStatus status = SolveStatus::CONVERGED;
  int steps = 0;          ///< accepted steps (time steps, or continuation steps of a steady state).
  int rejected = 0;       ///< steps that were restored and tried again with a smaller size.
  int iterations = 0;     ///< Newton iterations, those of rejected steps included.
  double residual = 0.0;  ///< largest force residual at the end [N].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(status, steps, rejected, iterations, residual);
  }
  /// Adds what another solve has cost.
  void addCost(const SolveReport& other)
  {
    steps += other.steps;
    rejected += other.rejected;
    iterations += other.iterations;
  }
  bool converged() const { return status == SolveStatus::CONVERGED; }
  /// A state was found, at rest or not.
  bool isUsable() const { return converged() || status == SolveStatus::NOT_AT_REST; }
};

}  // namespace tether_monitor::core
