// Uses the installed library as a stranger would: a tether in a current, and its monitor.
#include <cmath>
#include <cstdio>

#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/steady_state_solver.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"

int main()
{
  using namespace tether_monitor;
  monitor::Config config;
  config.tether.length = 100.0;
  config.tether.diameter = 0.012;
  config.tether.mass_per_length = 0.2;
  config.tether.axial_stiffness = 1e6;
  config.tether.drag_normal = 1.35;
  config.tether.drag_tangential = 0.04;
  config.tether.working_load = 1000.0;
  config.tether.breaking_load = 5000.0;
  config.elements = 20;

  const core::CableModel model(config.tether, config.elements, config.environment);
  core::SteadyStateSolver solver(model.nodes());
  core::NodeField shape;
  const core::SteadyEnds ends{{0.0, 0.0, 0.0}, {60.0, 0.0, -70.0}, {0.5, 0.0, 0.0}};
  if (!solver.solve(model, ends, shape).converged())
    return 1;
  const double tension = core::endForces(model, core::CableState(0.0, shape, ends.velocity)).vessel.norm();

  monitor::TetherEstimator estimator(config);
  monitor::EndTargets targets;
  targets.vessel = {ends.vessel, ends.velocity};
  targets.vehicle = {ends.vehicle, ends.velocity};
  const double estimate = estimator.begin(0.0, targets).vessel_tension;
  std::printf("%g N, %g N\n", tension, estimate);
  return std::abs(tension - estimate) < 1e-6 * tension ? 0 : 1;
}
