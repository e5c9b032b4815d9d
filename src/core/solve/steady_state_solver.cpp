#include "tether_monitor/core/solve/steady_state_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/assembly/prescribed_ends.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"
#include "tether_monitor/core/solve/grounded_catenary.h"
#include "tether_monitor/core/solve/initial_guess.h"

namespace tether_monitor::core
{
namespace
{
constexpr double FOLDED = 0.3;       // |r'| [-] below which an element is folded
constexpr double FIRST_MOVE = 0.01;  // first step: the load moves the tether by this share of its length
constexpr double HOMOTOPY_STIFFNESS[] = {100.0, 10.0, 1.0, 0.1};  // EI / (m g l^3) of the helpers [-]
constexpr double OBSTACLE_SHARES[] = {1e-4, 1e-2, 1.0};           // of their stiffness
constexpr double CREEP_TOLERANCE =
    3e-5;  // residual over the weight scale with which a slack tether counts as at rest
constexpr double INTERMEDIATE_TOLERANCE = 1e-4;  // relative tolerance of the first steps
constexpr double NEWTON_SWITCH = 1e9;  // growth of tau over the first step at which the flow is Newton's method

// Metric of the flow per unit of pseudo-time [kg/s-like]: unit line density, lumped.
void addMetric(const CableModel& model, double scale, BlockTridiagonal& tangent)
{
  for (int i = 0; i < model.elements(); ++i)
  {
    const double l = model.element(i).length;
    for (int node : {i, i + 1})
    {
      tangent.diagonal(node).diagonal().head<3>().array() += scale * 0.5 * l;
      tangent.diagonal(node).diagonal().tail<3>().array() += scale * l * l * l / 105.0;
    }
  }
}

void addMetricForce(const CableModel& model, double scale, const NodeField& q, const NodeField& start,
                    NodeField& residual)
{
  for (int i = 0; i < model.elements(); ++i)
  {
    const double l = model.element(i).length;
    for (int node : {i, i + 1})
    {
      residual[node].head<3>() += scale * 0.5 * l * (q[node] - start[node]).head<3>();
      residual[node].tail<3>() += scale * l * l * l / 105.0 * (q[node] - start[node]).tail<3>();
    }
  }
}

bool isFolded(const CableModel& model, const NodeField& q)
{
  for (int i = 0; i < model.elements(); ++i)
    for (const QuadraturePoint& point : QUADRATURE)
      if (interpolate(shapeSlopes(point.xi, model.element(i).length), elementCoords(q, i)).norm() < FOLDED)
        return true;
  return false;
}

// A steady state has the vessel end on its place; a body at the vehicle end is free.
PrescribedEnds steadyHeld(const CableModel& model)
{
  return {true, !model.bodies().vehicle};
}

bool dipsBelowFloor(const CableModel& model, const NodeField& shape)
{
  for (const NodeCoords& node : shape)
    if (node.z() < model.sea().floorAt(node.head<3>()).z)
      return true;
  return false;
}

bool risesAbove(double height, const NodeField& shape)
{
  return std::any_of(shape.begin() + 1, shape.end() - 1,
                     [&](const NodeCoords& node) { return node.z() > height; });
}

// How much of a tether that is lighter than water a body holds down [m].
double heldDown(const CableModel& model, const SteadyEnds& ends)
{
  const Vector3 pull = steadyForce(*model.bodies().vehicle, model.sea(), {0.0, 0.0, -100.0}, ends.velocity);
  const ElementParameters& e = model.element(0);
  const double lift = model.sea().gravity() * (model.sea().density() * e.area - e.mass);
  return std::clamp(-pull.z() / lift, 0.0, model.length());
}

// A tether that floats between its ends, or from the vessel to where its body hangs down.
NodeField floatingStart(const CableModel& model, const SteadyEnds& ends, double level)
{
  constexpr double TIGHT = 0.9;  // share of the floating length that lies between the ends
  Vector3 end = ends.vehicle;
  if (model.bodies().vehicle)
  {
    const Vector3 pull = steadyForce(*model.bodies().vehicle, model.sea(), {0.0, 0.0, -100.0}, ends.velocity);
    const double hangs = std::min(heldDown(model, ends), 0.9 * model.length());
    const double drift = std::hypot(pull.x(), pull.y());
    const Vector3 away = drift > 0.0 ? Vector3(pull.x() / drift, pull.y() / drift, 0.0) : Vector3::UnitX();
    const double down = std::max(level - ends.vessel.z(), 0.0);
    end = ends.vessel + TIGHT * std::max(model.length() - hangs - down, 0.0) * away;
    end.z() = level - hangs;
  }
  Vector3 drift =
      netLoad(model, {ends.vessel.x(), ends.vessel.y(), -1.0}, {end.x(), end.y(), -1.0}, ends.velocity);
  drift.z() = 0.0;
  return floatingCatenary(model, ends.vessel, end, drift);
}

// The curve that the tether takes without obstacles, more or less.
NodeField freeShape(const CableModel& model, const SteadyEnds& ends)
{
  const bool hangs = model.bodies().vehicle.has_value();
  const NodeField shape = hangs ? hangingBodyGuess(model, ends.vessel, ends.velocity, *model.bodies().vehicle)
                                : catenaryGuess(model, ends.vessel, ends.vehicle, ends.velocity);
  const std::optional<double> afloat = floatingHeight(model);
  const bool rises = afloat && (hangs ? heldDown(model, ends) < 0.95 * model.length()
                                      : risesAbove(*afloat + model.element(0).diameter, shape));
  if (rises)
  {
    const NodeField floating = floatingStart(model, ends, *afloat);
    return floating.empty() ? shape : floating;
  }
  if (!model.sea().hasSeabed() || !dipsBelowFloor(model, shape))
    return shape;
  const NodeField laid =
      groundedCatenary(model, ends.vessel, hangs ? Vector3(shape.back().head<3>()) : ends.vehicle);
  return laid.empty() ? shape : laid;
}

// Moves nodes out of obstacles by the shortest way, the ends apart.
void projectOutOfObstacles(const CableModel& model, NodeField& shape)
{
  constexpr int PASSES = 3;  // out of one obstacle may be into another
  for (int pass = 0; pass < PASSES; ++pass)
    for (const Obstacle& obstacle : model.environment().obstacles)
      for (int i = 1; i < model.elements(); ++i)
      {
        const SignedDistance gap =
            signedDistance(obstacle, shape[i].head<3>() - (obstacle.position - model.sea().origin()));
        const double inside = 0.5 * model.element(i).diameter - gap.distance;
        if (inside > 0.0)
          shape[i].head<3>() += inside * gap.normal;
      }
}

CableModel withSofterObstacles(const CableModel& model, double share)
{
  CableModel softer = model;
  std::vector<Obstacle> obstacles = model.environment().obstacles;
  for (Obstacle& obstacle : obstacles)
    obstacle.stiffness *= share;
  softer.sea().setObstacles(obstacles);
  return softer;
}

}  // namespace

NodeField startingShape(const CableModel& model, const SteadyEnds& ends)
{
  NodeField shape = freeShape(model, ends);
  projectOutOfObstacles(model, shape);
  return shape;
}

SteadyStateSolver::SteadyStateSolver(int nodes, const SteadyStateOptions& options)
  : options_(options),
    start_(nodes, NodeCoords::Zero()),
    residual_(start_),
    start_residual_(start_),
    tangent_(nodes)
{
}

SolveReport SteadyStateSolver::solve(const CableModel& model, const SteadyEnds& ends, NodeField& shape)
{
  if (!model.sea().wave().isCalm())
  {
    CableModel calm = model;
    calm.sea().withoutWaves();
    return solve(calm, ends, shape);
  }
  NodeField found;
  if (!model.environment().obstacles.empty())
  {
    // Where it would hang without obstacles tells on which side of them it lies.
    CableModel open = model;
    open.sea().setObstacles({});
    NodeField hanging;
    if (solve(open, ends, hanging).converged())
    {
      found = hanging;
      projectOutOfObstacles(model, found);
    }
  }
  if (found.empty())
    found = startingShape(model, ends);
  SolveReport report = solveFrom(model, ends, found);
  if (!report.converged())
  {
    // A stiffer tether has no bights that the mesh cannot carry; its steady state is a better start.
    found = startingShape(model, ends);
    for (const double stiffness : HOMOTOPY_STIFFNESS)
      report.addCost(solveFrom(model.stiffened(stiffness), ends, found));
    const SolveReport before = report;
    report = solveFrom(model, ends, found);
    report.addCost(before);
  }
  if (!report.converged() && !model.environment().obstacles.empty())
  {
    // Obstacles that come up softly push a tether that starts inside them aside.
    found = startingShape(model, ends);
    for (const double share : OBSTACLE_SHARES)
      report = solveFrom(withSofterObstacles(model, share), ends, found);
  }
  if (report.converged())
    shape = found;
  return report;
}

SolveReport SteadyStateSolver::solveFrom(const CableModel& model, const SteadyEnds& ends, NodeField& shape)
{
  trial_ = CableState(0.0, shape, ends.velocity);
  NodeField& q = trial_.q;
  q.front().head<3>() = ends.vessel;
  if (!model.bodies().vehicle)
    q.back().head<3>() = ends.vehicle;
  initializeContact(model, trial_);

  // A tether that is drawn over the floor slides on it. One at rest is held by it, else its slack would have no
  // place.
  const bool slides = ends.velocity.norm() > STANDSTILL || !model.hasContact();
  trial_.contact.friction = slides ? FrictionMode::SLIP : FrictionMode::STICK;
  SolveReport total = pseudoTransientContinuation(model);
  if (total.converged() && isFolded(model, q))
    total.status = SolveStatus::FOLDED_EQUILIBRIUM;
  if (total.converged())
    shape = q;
  return total;
}

SolveReport SteadyStateSolver::pseudoTransientContinuation(const CableModel& model)
{
  SolveReport total;
  NodeField& q = trial_.q;
  // First step: the mean load per metre moves a free tether by FIRST_MOVE of its length.
  const double tau_0 = FIRST_MOVE * model.length() / (model.forceScale() / model.length());
  double tau = tau_0, unbalanced = std::numeric_limits<double>::infinity();
  int iterations_left = options_.max_iterations;
  while (iterations_left > 0)
  {
    start_ = q;
    const bool is_newton = tau >= NEWTON_SWITCH * tau_0;
    // On the way a rough solution of each step is enough; the last step has no metric and must be exact.
    NewtonOptions newton = options_.newton;
    if (!is_newton)
      newton.relative_tolerance =
          std::max(newton.relative_tolerance, INTERMEDIATE_TOLERANCE / std::sqrt(std::max(tau / tau_0, 1.0)));
    const SolveReport report = pseudoTimeStep(model, is_newton ? 0.0 : 1.0 / tau, newton, iterations_left);
    total.iterations += report.iterations;
    total.residual = report.residual;
    total.status = report.status;
    if (!report.converged())
    {
      ++total.rejected;
      q = start_;
      tau *= 0.2;
      if (tau < 1e-9 * tau_0)
        return total;
      continue;
    }
    ++total.steps;
    unbalanced = 0.0;
    if (is_newton)
      return total;
    for (int i = 0; i < model.nodes(); ++i)
      unbalanced =
          std::max(unbalanced, (q[i] - start_[i]).head<3>().norm() / tau * model.length() / model.elements());
    if (trial_.contact.friction != FrictionMode::SLIP)
      commitFriction(model, trial_);
    tau *= report.iterations <= 4 ? 4.0 : 1.5;
  }
  // A slack tether that floats, or weighs nothing, creeps: nothing holds it in its place.
  total.residual = unbalanced;
  total.status = unbalanced <= CREEP_TOLERANCE * (0.1 * model.forceScale()) ? SolveStatus::CONVERGED
                                                                            : SolveStatus::ITERATION_LIMIT;
  return total;
}

ResidualSize SteadyStateSolver::assemble(const CableModel& model, double scale, const NewtonOptions& newton)
{
  model.assemble(trial_, TangentWeights{0.0, 0.0, 1.0}, residual_, tangent_);
  addMetric(model, scale, tangent_);
  addMetricForce(model, scale, trial_.q, start_, residual_);
  double reaction = 0.0;
  if (model.bodies().vehicle)
  {
    reaction = residual_.back().head<3>().norm();
    const AttachmentMotion at = attachmentMotion(trial_, trial_.q.size() - 1);
    const RigidBodyResidual body = rigidBodyResidual(*model.bodies().vehicle, model.sea(), 0.0, at,
                                                     AttitudeState(), Wrench(), TangentWeights{0.0, 0.0, 1.0});
    residual_.back().head<3>() += body.force;
    tangent_.diagonal(model.elements()).topLeftCorner<3, 3>() += body.force_n;
  }
  return imposePrescribedEnds(model, trial_.q, newton, steadyHeld(model), residual_, reaction);
}

bool SteadyStateSolver::solve(const CableModel& model)
{
  start_residual_ = residual_;
  if (tangent_.solve(model.kernel(), residual_))
    return true;
  residual_ = start_residual_;
  return tangent_.solvePivoted(residual_);
}

SolveReport SteadyStateSolver::pseudoTimeStep(const CableModel& model, double scale, const NewtonOptions& newton,
                                              int& iterations_left)
{
  SolveReport report;
  report.status = SolveStatus::NOT_CONVERGED;
  double previous = 0.0;
  for (int k = 0;; ++k)
  {
    const ResidualSize size = assemble(model, scale, newton);
    report.residual = size.largest;
    if (size.largest <= size.tolerance)
    {
      report.status = SolveStatus::CONVERGED;
      return report;
    }
    const bool diverging = k >= 12 && size.largest > 100.0 * previous;
    if (k == newton.max_iterations || iterations_left <= 0 || diverging)
      return report;
    // A Newton that goes round in circles at a kink of a law comes out of them with shorter steps.
    const double share = k >= 14 && size.largest > 0.5 * previous ? 0.5 : 1.0;
    previous = size.largest;
    imposePrescribedEnds(steadyHeld(model), tangent_);
    ++report.iterations;
    --iterations_left;
    if (!std::isfinite(size.largest) || !solve(model))
    {
      report.status = SolveStatus::SINGULAR;
      return report;
    }
    for (int i = 0; i < model.nodes(); ++i)
      trial_.q[i] -= share * residual_[i];
  }
}

}  // namespace tether_monitor::core
