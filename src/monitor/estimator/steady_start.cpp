#include <cmath>
#include <limits>

#include "tether_monitor/core/solve/dynamic_relaxation.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/monitor/model/model_factory.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double SETTLING_RETRY = 1.0;  // [s] between attempts to find a steady state
constexpr int STRUMMING_PASSES = 4;
}  // namespace

// Another deployed length for a tether that is not in motion.
bool TetherEstimator::setLength(double length)
{
  if (model_.canRepresentLength(length))
  {
    model_.setPayout({length, 0.0, 0.0});
    return true;
  }
  if (!isPossible(length))
    return false;
  core::MeshSelection mesh = mesh_;
  while (!canMesh(config_, length, mesh.elements))
    ++mesh.elements;
  core::CableModel model = makeModel(config_, length, mesh.elements);
  model.sea() = model_.sea();
  rebuild(std::move(model), mesh);
  return true;
}

void TetherEstimator::selectMesh(const core::SteadyEnds& ends)
{
  const double length = model_.length();
  const auto make = [&](int elements)
  {
    core::CableModel model = makeModel(config_, length, elements);
    model.sea() = model_.sea();
    return model;
  };
  const core::MeshSelection mesh =
      core::selectMesh(make, ends, *config_.accuracy, config_.solver, model_.elements());
  rebuild(mesh.elements == model_.elements() ? model_ : make(mesh.elements), mesh);
}

// A mesh serves as long as the tether is about as long, as taut and as fast.
bool TetherEstimator::needsMesh(const core::SteadyEnds& ends) const
{
  constexpr double LENGTH_SHARE = 0.1, CHORD_SHARE = 0.02, SPEED = 0.5;  // of the length, of the length, [m/s]
  const double length = model_.length(), chord = (ends.vessel - ends.vehicle).norm();
  return config_.accuracy && !(std::abs(length - mesh_length_) < LENGTH_SHARE * length &&
                               std::abs(chord - mesh_chord_) < CHORD_SHARE * length &&
                               (ends.velocity - mesh_velocity_).norm() < SPEED);
}

void TetherEstimator::rebuild(core::CableModel model, const core::MeshSelection& mesh)
{
  core::StepperOptions solver = config_.solver;
  solver.step = mesh.step;
  core::AdaptiveStepper stepper(model, solver);
  mesh_ = mesh;
  model_ = std::move(model);
  stepper_ = std::move(stepper);
  statics_ = core::SteadyStateSolver(model_.nodes());
  observer_.setNodes(model_.nodes());
  estimate_.stations = core::StationProfile(mesh.elements);
}

// The model with all the forces of a steady state.
core::CableModel TetherEstimator::modelAtRest() const
{
  return isVehicleObserved() ? observer_.modelWithInitialForces(model_, vehicle_.lastOrientation() * thrust_.force)
                             : model_;
}

bool TetherEstimator::settle(double t, const EndTargets& ends)
{
  const core::Vector3 old_origin = origin_;
  origin_ = {ends.vessel.position.x(), ends.vessel.position.y(), 0.0};
  const core::SteadyEnds steady{ends.vessel.position - origin_, ends.vehicle.position - origin_,
                                ends.vessel.velocity};
  moveObstacles(t, old_origin);
  model_.sea().setOrigin(origin_);
  settled_ = false;
  retry_settling_at_ = t + SETTLING_RETRY;
  if (ends.payout && !setLength(ends.payout->length))
    return false;
  model_.setPayout({model_.length(), 0.0, 0.0});
  core::NodeField shape;
  last_solve_ = initialize(steady, shape);
  if (last_solve_.converged() && needsMesh(steady))
  {
    const core::CableModel before = model_;
    const core::MeshSelection mesh_before = mesh_;
    mesh_length_ = model_.length();
    mesh_chord_ = (steady.vessel - steady.vehicle).norm();
    mesh_velocity_ = steady.velocity;
    selectMesh(steady);
    core::NodeField finer;
    const core::SolveReport report = initialize(steady, finer);
    if (report.converged())
      shape = finer;
    else
      rebuild(before, mesh_before);
  }
  if (!last_solve_.converged())
    return false;
  state_ = core::CableState(t, shape, ends.vessel.velocity);
  if (config_.drag_amplification > 1.0)
  {
    // The tether strums where it flows; that changes its shape, and so the flow.
    for (int pass = 0; pass < STRUMMING_PASSES && last_solve_.converged(); ++pass)
    {
      strumming_ = core::findLockIn(model_, state_, config_.drag_amplification);
      // An observed vehicle stays where it was seen: the force on it changes instead.
      last_solve_ =
          isVehicleObserved() ? initialize(steady, state_.q) : statics_.solveFrom(model_, steady, state_.q);
    }
    if (!last_solve_.converged())
      return false;
  }
  core::initializeContact(model_, state_);
  last_solve_ = core::relaxFriction(modelAtRest(), state_);
  if (!last_solve_.converged())
    return false;
  if (isVehicleObserved())
    observer_.begin(model_, origin_, state_);
  payout_rate_ = ends.payout && std::abs(ends.payout->rate) <= PayoutBuffer::FASTEST ? ends.payout->rate : 0.0;
  strumming_at_ = -std::numeric_limits<double>::infinity();
  settled_ = true;
  return true;
}

}  // namespace tether_monitor::monitor
