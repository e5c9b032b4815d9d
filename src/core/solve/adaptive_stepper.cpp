#include "tether_monitor/core/solve/adaptive_stepper.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
constexpr double MOST_STEPS = 1e6;  // full steps that one advance() takes on
constexpr int EASY_ITERATIONS = 6;  // a step that needed no more lets the next one grow

const StepperOptions& checked(const StepperOptions& options)
{
  throwIfInvalid("step control", validate(options));
  return options;
}
}  // namespace

std::vector<std::string> validate(const StepperOptions& options)
{
  BoundsCheck check("solver.");
  check.positive("step", options.step, "s");
  check.within("spectral_radius", options.spectral_radius, 0.0, 1.0, "[-]");
  check.within("max_halvings", options.max_halvings, 0, 30, "[-]");
  check.within("max_iterations", options.max_iterations, 1, 1e6, "[-]");
  check.within("corrections", options.corrections, 0, 100, "[-]");
  check.check(options.courant > 0.0 && options.courant <= 1.0, "courant", options.courant, "> 0 and <= 1");
  return check.problems();
}

AdaptiveStepper::TimeIntegrator AdaptiveStepper::makeIntegrator(const CableModel& model,
                                                                const StepperOptions& options)
{
  if (options.scheme == Scheme::ABARBANEL_ZWAS)
    return AbarbanelZwas(model, options.corrections);
  return GeneralizedAlpha(model, options.spectral_radius, options.newton);
}

AdaptiveStepper::AdaptiveStepper(const CableModel& model, const StepperOptions& options)
  : options_(checked(options)), integrator_(makeIntegrator(model, options))
{
}

void AdaptiveStepper::prepareObstacles(const CableModel& model)
{
  std::visit([&](auto& integrator) { integrator.prepareObstacles(model); }, integrator_);
}

SolveReport AdaptiveStepper::step(const CableModel& model, const BoundaryConditions& ends, double h,
                                  CableState& state)
{
  return std::visit([&](auto& integrator) { return integrator.step(model, ends, h, state); }, integrator_);
}

double AdaptiveStepper::largestStep(const CableModel& model, const CableState& state)
{
  if (auto* explicit_scheme = std::get_if<AbarbanelZwas>(&integrator_))
    return std::min(options_.step, options_.courant * explicit_scheme->stableStep(model, state));
  return options_.step;
}

void AdaptiveStepper::expectShock(CableState& state) const
{
  state.step = std::ldexp(options_.step, -options_.max_halvings);
  state.last_iterations = options_.newton.max_iterations;
}

SolveReport AdaptiveStepper::advance(const CableModel& model, const BoundaryConditions& ends, double t_end,
                                     CableState& state)
{
  SolveReport total;
  const double duration = t_end - state.time;
  if (!(duration > 0.0))
    return total;
  const double limit = largestStep(model, state);
  const double full_steps = std::ceil(duration / limit - 1e-9);
  const double largest = duration / full_steps;
  const double smallest = std::ldexp(limit, -options_.max_halvings);
  const double budget = options_.max_iterations * full_steps;

  if (!(full_steps <= MOST_STEPS))
  {
    total.status = SolveStatus::ITERATION_LIMIT;
    return total;
  }
  double h =
      state.step > 0.0 ? std::clamp(state.step * (1.0 + 1e-9), std::min(smallest, largest), largest) : largest;
  while (state.time < t_end)
  {
    const double left = t_end - state.time;
    const double pieces = std::ceil(left / h - 1e-6);
    const double try_h = left / std::max(pieces, 1.0);
    const SolveReport report = step(model, ends, try_h, state);
    total.iterations += report.iterations;
    total.residual = report.residual;
    if (report.converged())
    {
      ++total.steps;
      if (pieces <= 1.0)
        state.time = t_end;
      h = isExplicit() || report.iterations <= EASY_ITERATIONS ? std::min(2.0 * try_h, largest) : try_h;
      state.step = h;
    }
    else
    {
      ++total.rejected;
      h = 0.5 * try_h;
      if (h < smallest)
      {
        total.status = report.status;
        return total;
      }
    }
    if (total.iterations + total.steps > budget && state.time < t_end)
    {
      total.status = SolveStatus::ITERATION_LIMIT;
      return total;
    }
  }
  return total;
}

}  // namespace tether_monitor::core
