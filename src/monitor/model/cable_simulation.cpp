#include "tether_monitor/monitor/model/cable_simulation.h"

#include <cmath>
#include <limits>
#include <utility>

#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
bool MeshPurpose::serves(double length_now, const core::SteadyEnds& ends) const
{
  constexpr double LENGTH_SHARE = 0.1, CHORD_SHARE = 0.02, SPEED = 0.5;  // of the length, of the length, [m/s]
  return std::abs(length_now - length) < LENGTH_SHARE * length_now &&
         std::abs((ends.vessel - ends.vehicle).norm() - chord) < CHORD_SHARE * length_now &&
         (ends.velocity - velocity).norm() < SPEED;
}

CableSimulation::CableSimulation(const Config& config)
  : model(makeModel(config)),
    stepper(model, config.solver),
    steady_solver(model.nodes()),
    cable(model),
    mesh{config.elements, config.solver.step, std::numeric_limits<double>::quiet_NaN(), !config.accuracy},
    options_(config.solver)
{
}

void CableSimulation::setModel(const core::CableModel& other, const core::MeshSelection& selection)
{
  core::StepperOptions options = options_;
  options.step = selection.step;
  stepper = core::AdaptiveStepper(other, options);
  steady_solver = core::SteadyStateSolver(other.nodes());
  cable = core::DeployedCable(other);
  model = other;
  mesh = selection;
  state.deployment = core::Deployment();
}

bool CableSimulation::setLength(const Config& config, double length)
{
  if (model.canRepresentLength(length))
  {
    state.deployment.payout = core::PayoutState{length, 0.0, 0.0};
    return true;
  }
  if (!canDeploy(config, model, length))
    return false;
  core::MeshSelection selection = mesh;
  while (!canMesh(config, length, selection.elements))
    ++selection.elements;
  setModel(makeModel(config, length, selection.elements).withEnvironment(model.environment()), selection);
  return true;
}

}  // namespace tether_monitor::monitor
