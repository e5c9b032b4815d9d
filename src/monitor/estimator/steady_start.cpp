#include "tether_monitor/monitor/estimator/steady_start.h"

#include <cmath>

#include "tether_monitor/core/solve/dynamic_relaxation.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr int VORTEX_SHEDDING_PASSES = 4;

// One search for a start; each step works on what the one before has left in `start`.
class StartSearch
{
 public:
  StartSearch(const Config& config, const VehicleEnd& vehicle, const EndTargets& targets, SteadyStart& start)
    : config_(config), vehicle_(vehicle), targets_(targets), start_(start), simulation_(start.simulation)
  {
  }

  bool run(double t, const std::vector<core::Obstacle>& obstacles)
  {
    return placeOrigin(obstacles) && setLength() && findShape() && refineMesh() && enterState(t) &&
           amplifyDrag() && settleContact() && complete() && addHeave();
  }

 private:
  bool isFound() const { return simulation_.last_solve.isUsable(); }

  bool placeOrigin(const std::vector<core::Obstacle>& obstacles)
  {
    const core::Vector3 origin(targets_.vessel.position.x(), targets_.vessel.position.y(), 0.0);
    simulation_.model = simulation_.model.withEnvironment(
        simulation_.model.environment().withObstacles(obstacles).withOrigin(origin));
    core::Vector3 mean_velocity = targets_.vessel.velocity;
    mean_velocity.z() = 0.0;
    ends_ = {targets_.vessel.position - origin, targets_.vehicle.position - origin, mean_velocity, {}};
    ends_.clamps = targets_.clamps;
    return true;
  }

  bool setLength()
  {
    const double length = targets_.payout ? targets_.payout->length : simulation_.length();
    simulation_.last_solve.status = core::SolveStatus::NOT_CONVERGED;
    if (!simulation_.setLength(config_, length))
      return false;
    ends_.deployment = simulation_.state.deployment;
    return true;
  }

  bool findShape()
  {
    simulation_.last_solve = vehicle_.findStart(simulation_, ends_, targets_, start_.vehicle);
    return isFound();
  }

  // A mesh for the wanted accuracy; if nothing is found on it, that before.
  bool refineMesh()
  {
    if (!config_.accuracy ||
        (simulation_.mesh_purpose && simulation_.mesh_purpose->serves(simulation_.length(), ends_)))
      return true;
    const MeshPurpose purpose{simulation_.length(), (ends_.vessel - ends_.vehicle).norm(), ends_.velocity};
    const SteadyStart before = start_;
    const core::SteadyEnds ends_before = ends_;
    selectMesh(purpose.length);
    if (vehicle_.findStart(simulation_, ends_, targets_, start_.vehicle).isUsable())
    {
      simulation_.mesh_purpose = purpose;
      return true;
    }
    start_ = before;
    ends_ = ends_before;
    simulation_.mesh_purpose = purpose;  // not tried again for the same
    return true;
  }

  void selectMesh(double length)
  {
    const core::EnvironmentModel environment = simulation_.model.environment();
    const auto make = [&](int elements)
    { return makeModel(config_, length, elements).withEnvironment(environment); };
    core::SteadyEnds ends = ends_;
    ends.deployment = core::Deployment();
    const core::MeshSelection mesh =
        core::selectMesh(make, ends, *config_.accuracy, config_.solver, simulation_.model.elements());
    const bool is_same = mesh.elements == simulation_.model.elements();
    const core::Deployment deployment = is_same ? simulation_.state.deployment : core::Deployment();
    simulation_.setModel(is_same ? core::CableModel(simulation_.model) : make(mesh.elements), mesh);
    simulation_.state.deployment = deployment;
    ends_.deployment = deployment;
  }

  bool enterState(double t)
  {
    simulation_.state = core::CableState(t, start_.vehicle.shape, ends_.velocity, ends_.deployment);
    simulation_.state.clamps = ends_.clamps;
    return true;
  }

  // The drag grows where vortices shed; that changes the shape, and so the flow.
  bool amplifyDrag()
  {
    core::CableState& state = simulation_.state;
    for (int pass = 0; config_.drag_amplification > 1.0 && pass < VORTEX_SHEDDING_PASSES && isFound(); ++pass)
    {
      start_.vortex_shedding = core::findLockIn(simulation_.updatedCable(), state, config_.drag_amplification,
                                                state.deployment.drag_factor);
      ends_.deployment = state.deployment;
      simulation_.last_solve = vehicle_.refineStart(simulation_, ends_, targets_, start_.vehicle);
      state.q = start_.vehicle.shape;
    }
    return isFound();
  }

  bool settleContact()
  {
    simulation_.updatedCable().initializeContact(simulation_.state);
    const core::SolveReport settled =
        core::settleContact(simulation_.steady_solver, vehicle_.modelAtRest(simulation_.model, start_.vehicle),
                            ends_, simulation_.state);
    simulation_.last_solve.addCost(settled);
    if (simulation_.last_solve.converged())
      simulation_.last_solve.status = settled.status;
    else if (!settled.isUsable())
      return false;
    return isFound();
  }

  bool complete()
  {
    if (vehicle_.completeStart(simulation_, ends_, targets_, start_.vehicle))
      return true;
    simulation_.last_solve.status = core::SolveStatus::NOT_CONVERGED;
    return false;
  }

  // The ends' motion of the moment on top of the mean: in between by the arc length, as a taut tether moves.
  bool addHeave()
  {
    const bool is_held = !simulation_.model.bodies().vehicle;
    const core::Vector3 vessel = targets_.vessel.velocity - ends_.velocity;
    const core::Vector3 vehicle =
        is_held ? core::Vector3(targets_.vehicle.velocity - ends_.velocity) : core::Vector3::Zero();
    const core::DeployedCable& cable = simulation_.updatedCable();
    for (int i = 0; i < cable.nodes(); ++i)
    {
      const double share = cable.arcLength(i) / cable.length();
      simulation_.state.v[i].head<3>() += (1.0 - share) * vessel + share * vehicle;
      simulation_.state.v[i].tail<3>() += (vehicle - vessel) / cable.length();
    }
    return true;
  }

  const Config& config_;
  const VehicleEnd& vehicle_;
  const EndTargets& targets_;
  SteadyStart& start_;
  CableSimulation& simulation_;
  core::SteadyEnds ends_;
};
}  // namespace

SteadyStart findSteadyStart(const Config& config, const CableSimulation& simulation,
                            const std::vector<core::Obstacle>& obstacles, const VehicleEnd& vehicle, double t,
                            const EndTargets& targets)
{
  SteadyStart start{simulation, {}, {}};
  start.is_found = StartSearch(config, vehicle, targets, start).run(t, obstacles);
  return start;
}

}  // namespace tether_monitor::monitor
