#include "tether_monitor/core/solve/abarbanel_zwas.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/core/base/so3.h"

namespace tether_monitor::core
{
namespace
{
// Largest eigenfrequency of a Hermite element: axial 6.48 c / l, bending 92 sqrt(EI / m) / l^2.
constexpr double AXIAL_SHARE = 42.0, BENDING_SHARE = 8400.0;
constexpr double MASS_SHARE = 4.0;  // a point of an element moves a part of its mass only
const TangentWeights MASS_ONLY{1.0, 0.0, 0.0};
}  // namespace

AbarbanelZwas::AbarbanelZwas(const CableModel& model, int corrections)
  : corrections_(corrections),
    cable_(model),
    residual_(model.nodes(), NodeCoords::Zero()),
    mass_(model.nodes()),
    blocks_(model.nodes())
{
  BoundsCheck check("solver.");
  check.within("corrections", corrections, 0, 100, "[-]");
  throwIfInvalid("AbarbanelZwas", check.problems());
  trial_ = CableState(0.0, residual_, Vector3::Zero());
  trial_.deployment.drag_factor.reserve(model.elements());
  prepareObstacles(model);
}

void AbarbanelZwas::prepareObstacles(const CableModel& model)
{
  bordered_ = borderedSystemFor(model.environment().obstacles(), model.nodes(), movable_obstacles_);
  cable_.update(model, trial_.deployment);
  cable_.initializeContact(trial_);
}

double AbarbanelZwas::stableStep(const DeployedCable& cable)
{
  const PrescribedEnds held = prescribedEnds(cable.bodies());
  const double limit = held.vessel && held.vehicle ? HELD_LIMIT : FREE_LIMIT;
  double touch = 0.0, brake = 0.0;  // stiffest surface [N/m^3] and its damper [N s/m^3]
  if (const std::optional<Seabed>& seabed = cable.environment().seabed())
  {
    touch = seabed->normal_stiffness;
    brake = seabed->damping;
  }
  for (const Obstacle& obstacle : cable.environment().obstacles())
  {
    touch = std::max(touch, obstacle.stiffness);
    brake = std::max(brake, OBSTACLE_DAMPING * obstacle.stiffness);
  }
  double smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < cable.elements(); ++i)
  {
    const ElementParameters& e = cable.element(i);
    if (e.parted)
      continue;
    const double l2 = e.length * e.length;
    const double stretch = 1.0 + 0.2;  // Green-Lagrange stiffens: 3/2 strain at up to some 10 %
    const double axial = stretch * AXIAL_SHARE * e.axial.largestModulus() / (e.mass * l2);
    const double bending = BENDING_SHARE * e.bending_stiffness / (e.mass * l2 * l2);
    const double contact = MASS_SHARE * touch * e.contact_diameter / e.mass;
    const double w = std::sqrt(axial + bending + contact);
    const double damping = 0.5 * (e.axial.damping * axial + MASS_SHARE * brake * e.contact_diameter / e.mass) / w;
    const double h = limit * std::sqrt(AXIAL_SHARE) / w;
    smallest = std::min(smallest, h * (std::hypot(1.0, damping) - damping));
  }
  return smallest;
}

double AbarbanelZwas::stableStep(const CableModel& model, const CableState& state)
{
  cable_.update(model, state.deployment);
  return stableStep(cable_);
}

void AbarbanelZwas::assemble(const BoundaryConditions& ends, bool first)
{
  const bool has_movable = !movable_obstacles_.empty();
  if (has_movable)
    bordered_.setZero();
  if (first || has_movable)
    cable_.assemble(trial_, MASS_ONLY, residual_, mass_, TangentKind::SYMMETRIC,
                    has_movable ? &bordered_ : nullptr);
  else
    cable_.assemble(trial_, residual_);
  bodies_.assemble(cable_, trial_, ends, MASS_ONLY, residual_, mass_);
  bodies_.condense(cable_.bodies(), residual_);

  const PrescribedEnds held = prescribedEnds(cable_.bodies());
  if (held.vessel)
    residual_.front().head<3>().setZero();
  if (held.vehicle)
    residual_.back().head<3>().setZero();
  if (!first)
    return;
  imposePrescribedEnds(held, mass_);
  for (int i = 0; i < cable_.nodes(); ++i)
    blocks_[i].compute(mass_.diagonal(i));
}

void AbarbanelZwas::place(const BoundaryConditions& ends, double h, const CableState& state)
{
  for (std::size_t i = 0; i < state.q.size(); ++i)
  {
    // The layer of one step before, by the state's own rates; then (42).
    const NodeCoords before = state.q[i] - h * state.v[i] + 0.5 * h * h * state.a[i];
    trial_.q[i] = 2.0 * state.q[i] - before + h * h * trial_.a[i];
    trial_.v[i] = (trial_.q[i] - state.q[i]) / h + 0.5 * h * trial_.a[i];
  }
  placePrescribedEnds(cable_.bodies(), ends, trial_);
  const auto rotate = [&](const AttitudeState& from, AttitudeState& to)
  {
    to.velocity = from.velocity + h * to.acceleration;
    to.orientation = from.orientation * expSO3(h * from.velocity + 0.5 * h * h * to.acceleration);
  };
  rotate(state.vessel, trial_.vessel);
  rotate(state.vehicle, trial_.vehicle);
  for (std::size_t k = 0; k < state.obstacles.size(); ++k)
  {
    ObstacleMotion& to = trial_.obstacles[k];
    to.velocity = state.obstacles[k].velocity + h * to.acceleration;
    to.position = state.obstacles[k].position + h * state.obstacles[k].velocity + 0.5 * h * h * to.acceleration;
  }
}

// The old layer with no accelerations.
void AbarbanelZwas::beginLayer(double h, const CableState& state)
{
  trial_.contact = state.contact;
  trial_.contact.step = h;
  trial_.time = state.time;
  trial_.step = h;
  trial_.deployment = state.deployment;
  trial_.q = state.q;
  trial_.v = state.v;
  trial_.vessel = state.vessel;
  trial_.vehicle = state.vehicle;
  trial_.obstacles = state.obstacles;
  for (NodeCoords& a : trial_.a)
    a.setZero();
  trial_.vessel.acceleration.setZero();
  trial_.vehicle.acceleration.setZero();
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.acceleration.setZero();
}

void AbarbanelZwas::accept(CableState& state)
{
  trial_.algorithmic_acceleration = trial_.a;
  trial_.vessel.orientation.normalize();
  trial_.vehicle.orientation.normalize();
  trial_.vessel.algorithmic_acceleration = trial_.vessel.acceleration;
  trial_.vehicle.algorithmic_acceleration = trial_.vehicle.acceleration;
  for (ObstacleMotion& obstacle : trial_.obstacles)
    obstacle.algorithmic_acceleration = obstacle.acceleration;
  cable_.commitFriction(trial_);
  std::swap(state, trial_);
}

SolveReport AbarbanelZwas::step(const CableModel& model, const BoundaryConditions& ends, double h,
                                CableState& state)
{
  SolveReport report;
  cable_.update(model, state.deployment);
  if (state.obstacles.size() != model.environment().obstacles().size())
    cable_.initializeContact(state);
  beginLayer(h, state);
  for (int k = 0; k <= corrections_; ++k)
  {
    // First the forces of the old layer and no neighbours (45), then those of the new layer (47).
    assemble(ends, k == 0);
    for (std::size_t i = 0; i < trial_.a.size(); ++i)
      trial_.a[i] -= residual_[i] = blocks_[i].solve(residual_[i]).eval();
    if (cable_.bodies().vessel)
      trial_.vessel.acceleration -= bodies_.solveVessel(residual_);
    if (cable_.bodies().vehicle)
      trial_.vehicle.acceleration -= bodies_.solveVehicle(residual_);
    for (const int p : movable_obstacles_)
      trial_.obstacles[p].acceleration = -bordered_.residual(p) / cable_.environment().obstacles()[p].mass;
    if (k == 0)
    {
      trial_.time = state.time + h;
      if (ends.payout)
        trial_.deployment.payout = ends.payout->at(trial_.time);
      cable_.update(model, trial_.deployment);
    }
    place(ends, h, state);
    ++report.iterations;
  }
  if (!trial_.allFinite())
  {
    report.status = SolveStatus::SINGULAR;
    return report;
  }
  report.steps = 1;
  accept(state);
  return report;
}

}  // namespace tether_monitor::core
