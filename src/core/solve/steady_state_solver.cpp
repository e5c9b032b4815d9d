#include "tether_monitor/core/solve/steady_state_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/core/element/element_coordinates.h"
#include "tether_monitor/core/element/hermite_shape_functions.h"
#include "tether_monitor/core/element/quadrature.h"
#include "tether_monitor/core/solve/starting_shape.h"

namespace tether_monitor::core
{
namespace
{
constexpr double FOLDED = 0.3;       // |r'| [-] below which an element is folded
constexpr double COMPRESSED = 0.9;   // of its natural length, below which it stands like a strut
constexpr double FIRST_MOVE = 0.01;  // first step: the load moves the tether by this share of its length
constexpr double HOMOTOPY_STIFFNESS[] = {100.0, 10.0, 1.0, 0.1};  // EI / (m g l^3) of the helpers [-]
constexpr double OBSTACLE_SHARES[] = {1e-4, 1e-2, 1.0};           // of their stiffness
constexpr double CREEP_TOLERANCE =
    3e-5;  // residual over the weight scale with which a slack tether counts as at rest
constexpr double INTERMEDIATE_TOLERANCE = 1e-4;  // relative tolerance of the first steps,
constexpr double COARSE_ELEMENTS = 50.0;         // with so many elements; a node of more carries less
constexpr double NEWTON_SWITCH =
    1e9;  // growth of tau over the first step at which the continuation is Newton's method

// Metric of the continuation per unit of pseudo-time [kg/s-like]: unit line density, lumped.
void addMetric(const DeployedCable& cable, double scale, BlockTridiagonal& tangent)
{
  for (int i = 0; i < cable.elements(); ++i)
  {
    const double l = cable.element(i).length;
    for (int node : {i, i + 1})
    {
      tangent.diagonal(node).diagonal().head<3>().array() += scale * 0.5 * l;
      tangent.diagonal(node).diagonal().tail<3>().array() += scale * l * l * l / 105.0;
    }
  }
}

void addMetricForce(const DeployedCable& cable, double scale, const NodeField& q, const NodeField& start,
                    NodeField& residual)
{
  for (int i = 0; i < cable.elements(); ++i)
  {
    const double l = cable.element(i).length;
    for (int node : {i, i + 1})
    {
      residual[node].head<3>() += scale * 0.5 * l * (q[node] - start[node]).head<3>();
      residual[node].tail<3>() += scale * l * l * l / 105.0 * (q[node] - start[node]).tail<3>();
    }
  }
}

// No tether is: an element turned inside out, or a strut in a balance that the least push would end.
bool isFolded(const DeployedCable& cable, const NodeField& q)
{
  for (int i = 0; i < cable.elements(); ++i)
  {
    const ElementParameters& p = cable.element(i);
    const ElementCoords e = elementCoords(p, q, i);
    double stretch = 0.0;
    for (const QuadraturePoint& point : QUADRATURE)
    {
      const double slope = interpolate(shapeSlopes(point.xi, p.length), e).norm();
      if (slope < FOLDED)
        return true;
      stretch += point.weight * slope;
    }
    if (stretch < COMPRESSED * p.natural_stretch)
      return true;
  }
  return false;
}

// A steady state has the vessel end on its place; a body at the vehicle end is free.
PrescribedEnds steadyHeld(const EndBodies& bodies)
{
  return {true, !bodies.vehicle};
}

CableModel withSofterObstacles(const CableModel& model, double share)
{
  std::vector<Obstacle> obstacles = model.environment().obstacles();
  for (Obstacle& obstacle : obstacles)
    obstacle.stiffness *= share;
  return model.withEnvironment(model.environment().withObstacles(obstacles));
}

// The deployed length at rest.
Deployment atRest(const CableModel& model, const SteadyEnds& ends)
{
  Deployment deployment = ends.deployment;
  if (deployment.payout)
    deployment.payout = PayoutState{model.length(deployment), 0.0, 0.0};
  return deployment;
}
}  // namespace

SteadyStateSolver::SteadyStateSolver(int nodes, const SteadyStateOptions& options)
  : options_(options), residual_(nodes, NodeCoords::Zero()), tangent_(nodes)
{
}

SteadyStateSolver::Search::Search(const CableModel& model, const SteadyEnds& ends)
  : cable(model, atRest(model, ends)), start(model.nodes(), NodeCoords::Zero()), start_residual(start)
{
}

// Where the tether would hang without obstacles shows on which side of them it lies.
NodeField SteadyStateSolver::firstGuess(const DeployedCable& cable, const SteadyEnds& ends)
{
  if (!cable.environment().obstacles().empty())
  {
    NodeField hanging;
    if (solve(cable.model().withEnvironment(cable.environment().withObstacles({})), ends, hanging).converged())
    {
      projectOutOfObstacles(cable, hanging);
      return hanging;
    }
  }
  return startingShape(cable, ends);
}

// A stiffer tether has no bights that the mesh cannot carry; its steady state is a better start.
SolveReport SteadyStateSolver::searchByStiffening(const SteadyEnds& ends, Search& search, NodeField& shape)
{
  SolveReport cost;
  shape = startingShape(search.cable, ends);
  const CableModel model = search.cable.model();
  const Deployment deployment = atRest(model, ends);
  for (const double stiffness : HOMOTOPY_STIFFNESS)
  {
    search.cable.update(model, deployment);
    search.cable.stiffen(stiffness);
    cost.addCost(searchFrom(ends, search, shape));
  }
  search.cable.update(model, deployment);
  SolveReport report = searchFrom(ends, search, shape);
  report.addCost(cost);
  return report;
}

// Obstacles that come up softly push a tether that starts inside them aside.
SolveReport SteadyStateSolver::searchByObstacleStiffness(const CableModel& model, const SteadyEnds& ends,
                                                         NodeField& shape)
{
  SolveReport report;
  shape = startingShape(DeployedCable(model, atRest(model, ends)), ends);
  for (const double share : OBSTACLE_SHARES)
    report = solveFrom(withSofterObstacles(model, share), ends, shape);
  return report;
}

SolveReport SteadyStateSolver::solve(const CableModel& model, const SteadyEnds& ends, NodeField& shape)
{
  if (!model.environment().waves().isCalm())
    return solve(model.withEnvironment(model.environment().withoutWaves()), ends, shape);
  Search search(model, ends);
  NodeField found = firstGuess(search.cable, ends);
  SolveReport report = searchFrom(ends, search, found);
  if (!report.converged())
  {
    const SolveReport before = report;
    report = searchByStiffening(ends, search, found);
    report.addCost(before);
  }
  if (!report.converged() && !model.environment().obstacles().empty())
    report = searchByObstacleStiffness(model, ends, found);
  if (report.converged())
    shape = found;
  return report;
}

SolveReport SteadyStateSolver::solveFrom(const CableModel& model, const SteadyEnds& ends, NodeField& shape)
{
  Search search(model, ends);
  return searchFrom(ends, search, shape);
}

SolveReport SteadyStateSolver::settleFriction(const CableModel& model, const SteadyEnds& ends, CableState& state)
{
  Search search(model, ends);
  trial_ = state;
  trial_.contact.friction = FrictionMode::COULOMB;
  trial_.contact.step = 0.0;
  const SolveReport report = pseudoTransientContinuation(search);
  if (report.converged())
  {
    search.cable.commitFriction(trial_);
    state.q = trial_.q;
    state.contact = trial_.contact;
  }
  return report;
}

SolveReport SteadyStateSolver::searchFrom(const SteadyEnds& ends, Search& search, NodeField& shape)
{
  const DeployedCable& cable = search.cable;
  trial_ = CableState(0.0, shape, ends.velocity, ends.deployment);
  trial_.clamps = ends.clamps;
  trial_.q.front().head<3>() = ends.vessel;
  if (!cable.bodies().vehicle)
    trial_.q.back().head<3>() = ends.vehicle;
  cable.initializeContact(trial_);

  // A tether that is drawn over the floor slides on it. One at rest is held by it, else its slack would have no
  // place.
  const bool slides = ends.velocity.norm() > STANDSTILL || !cable.environment().hasContact();
  trial_.contact.friction = slides ? FrictionMode::SLIP : FrictionMode::STICK;
  SolveReport total = pseudoTransientContinuation(search);
  if (total.converged() && isFolded(cable, trial_.q))
    total.status = SolveStatus::FOLDED_EQUILIBRIUM;
  if (total.converged())
    shape = trial_.q;
  return total;
}

SolveReport SteadyStateSolver::pseudoTransientContinuation(Search& search)
{
  SolveReport total;
  const DeployedCable& cable = search.cable;
  NodeField& q = trial_.q;
  // First step: the mean load per metre moves a free tether by FIRST_MOVE of its length.
  const double tau_0 = FIRST_MOVE * cable.length() / (cable.forceScale() / cable.length());
  double tau = tau_0, unbalanced = std::numeric_limits<double>::infinity();
  int iterations_left = options_.max_iterations;
  while (iterations_left > 0)
  {
    search.start = q;
    const bool is_newton = tau >= NEWTON_SWITCH * tau_0;
    // At first a rough solution of each step is enough; the last step has no metric and must be exact.
    NewtonOptions newton = options_.newton;
    if (!is_newton)
      newton.relative_tolerance = std::max(
          newton.relative_tolerance, INTERMEDIATE_TOLERANCE * std::min(1.0, COARSE_ELEMENTS / cable.elements()) /
                                         std::sqrt(std::max(tau / tau_0, 1.0)));
    const SolveReport report = pseudoTimeStep(is_newton ? 0.0 : 1.0 / tau, newton, search, iterations_left);
    total.iterations += report.iterations;
    total.residual = report.residual;
    total.status = report.status;
    if (!report.converged())
    {
      ++total.rejected;
      q = search.start;
      tau *= 0.2;
      if (tau < 1e-9 * tau_0)
        return total;
      continue;
    }
    ++total.steps;
    unbalanced = 0.0;
    if (is_newton)
      return total;
    for (int i = 0; i < cable.nodes(); ++i)
      unbalanced = std::max(unbalanced,
                            (q[i] - search.start[i]).head<3>().norm() / tau * cable.length() / cable.elements());
    if (trial_.contact.friction != FrictionMode::SLIP)
      cable.commitFriction(trial_);
    tau *= report.iterations <= 4 ? 4.0 : 1.5;
  }
  // A slack tether that floats, or weighs nothing, drifts: nothing holds it in its place.
  total.residual = unbalanced;
  total.status = unbalanced <= CREEP_TOLERANCE * (0.1 * cable.forceScale()) ? SolveStatus::CONVERGED
                                                                            : SolveStatus::ITERATION_LIMIT;
  return total;
}

ResidualSize SteadyStateSolver::assemble(double scale, const NewtonOptions& newton, const Search& search)
{
  const DeployedCable& cable = search.cable;
  const TangentWeights stiffness_only{0.0, 0.0, 1.0};
  cable.assemble(trial_, stiffness_only, residual_, tangent_);
  addMetric(cable, scale, tangent_);
  addMetricForce(cable, scale, trial_.q, search.start, residual_);
  double reaction = 0.0;
  if (cable.bodies().vehicle)
  {
    reaction = residual_.back().head<3>().norm();
    const RigidBodyMotion motion = rigidBodyMotion(trial_, trial_.q.size() - 1, AttitudeState());
    const RigidBodyResidual body =
        rigidBodyResidual(*cable.bodies().vehicle, cable.environment(), motion, Wrench(), stiffness_only);
    residual_.back().head<3>() += body.force;
    tangent_.diagonal(cable.elements()).topLeftCorner<3, 3>() += body.force_n;
  }
  return imposePrescribedEnds(cable, trial_.q, newton, steadyHeld(cable.bodies()), residual_, reaction);
}

bool SteadyStateSolver::solve(Search& search)
{
  search.start_residual = residual_;
  if (tangent_.solve(search.cable.model().kernel().solve, residual_))
    return true;
  residual_ = search.start_residual;
  return tangent_.solvePivoted(residual_);
}

SolveReport SteadyStateSolver::pseudoTimeStep(double scale, const NewtonOptions& newton, Search& search,
                                              int& iterations_left)
{
  SolveReport report;
  report.status = SolveStatus::NOT_CONVERGED;
  double previous = 0.0;
  for (int k = 0;; ++k)
  {
    const ResidualSize size = assemble(scale, newton, search);
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
    imposePrescribedEnds(steadyHeld(search.cable.bodies()), tangent_);
    ++report.iterations;
    --iterations_left;
    if (!std::isfinite(size.largest) || !solve(search))
    {
      report.status = SolveStatus::SINGULAR;
      return report;
    }
    for (std::size_t i = 0; i < trial_.q.size(); ++i)
      trial_.q[i] -= share * residual_[i];
  }
}

}  // namespace tether_monitor::core
