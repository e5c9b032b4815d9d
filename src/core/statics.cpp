#include "tether_monitor/core/statics.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/held_ends.h"
#include "tether_monitor/core/initial_shape.h"
#include "tether_monitor/core/laid_shape.h"
#include "tether_monitor/core/quadrature.h"
#include "tether_monitor/core/shape_functions.h"

namespace tether_monitor::core
{
namespace
{
constexpr double FOLDED = 0.3;            // |r'| [-] below which an element is folded
constexpr double FIRST_MOVE = 0.01;       // first step: the load moves the tether by this share of its length
constexpr double HELPER_STIFFNESS = 0.1;  // EI / (m g l^3) of the helper [-]
constexpr double OBSTACLE_SHARES[] = {1e-4, 1e-2, 1.0};  // of their stiffness
constexpr double NEWTON_TAU = 1e9;  // growth of tau over the first step at which the flow is Newton's method

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
    for (const GaussPoint& point : GAUSS_POINTS)
      if (interpolate(shapeSlopes(point.xi, model.element(i).length), elementCoords(q, i)).norm() < FOLDED)
        return true;
  return false;
}

// A steady state has the vessel end on its place; a body at the vehicle end is free.
HeldEnds steadyHeld(const CableModel& model)
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

// The curve that the tether takes without obstacles, more or less.
NodeField freeShape(const CableModel& model, const SteadyEnds& ends)
{
  const bool hangs = model.bodies().vehicle.has_value();
  const NodeField shape = hangs ? hangingShape(model, ends.vessel, ends.velocity, *model.bodies().vehicle)
                                : initialShape(model, ends.vessel, ends.vehicle, ends.velocity);
  if (!model.sea().hasSeabed() || !dipsBelowFloor(model, shape))
    return shape;
  const NodeField laid = laidShape(model, ends.vessel, hangs ? Vector3(shape.back().head<3>()) : ends.vehicle);
  return laid.empty() ? shape : laid;
}

// Moves nodes out of obstacles by the shortest way, the ends apart.
void pushOut(const CableModel& model, NodeField& shape)
{
  constexpr int PASSES = 3;  // out of one obstacle may be into another
  for (int pass = 0; pass < PASSES; ++pass)
    for (const Obstacle& obstacle : model.environment().obstacles)
      for (int i = 1; i < model.elements(); ++i)
      {
        const Separation gap =
            separation(obstacle, shape[i].head<3>() - (obstacle.position - model.sea().origin()));
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
  pushOut(model, shape);
  return shape;
}

Statics::Statics(int nodes, const StaticsOptions& options)
  : options_(options), start_(nodes, NodeCoords::Zero()), residual_(start_), tangent_(nodes)
{
}

SolveReport Statics::solve(const CableModel& model, const SteadyEnds& ends, NodeField& shape)
{
  if (!model.sea().wave().isCalm())
  {
    CableModel calm = model;
    calm.sea().calm();
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
      pushOut(model, found);
    }
  }
  if (found.empty())
    found = startingShape(model, ends);
  SolveReport report = solveFrom(model, ends, found);
  if (!report.converged())
  {
    // A stiffer tether has no bights that the mesh cannot carry; its steady state is a better start.
    found = startingShape(model, ends);
    const SolveReport stiff = solveFrom(model.stiffened(HELPER_STIFFNESS), ends, found);
    const SolveReport again = solveFrom(model, ends, found);
    const SolveReport first = report;
    report = again;
    report.addCost(first);
    report.addCost(stiff);
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

SolveReport Statics::solveFrom(const CableModel& model, const SteadyEnds& ends, NodeField& shape)
{
  trial_ = CableState(0.0, shape, ends.velocity);
  NodeField& q = trial_.q;
  q.front().head<3>() = ends.vessel;
  if (!model.bodies().vehicle)
    q.back().head<3>() = ends.vehicle;
  beginContact(model, trial_);

  // A tether that is drawn over the floor slides on it. One at rest is held by it, else its slack would have no
  // place.
  const bool slides = ends.velocity.norm() > STANDSTILL || !model.hasContact();
  trial_.contact.friction = slides ? FrictionMode::SLIDING : FrictionMode::GLUED;
  SolveReport total = relax(model);
  if (total.converged() && isFolded(model, q))
    total.status = SolveStatus::FALSE_BRANCH;
  if (total.converged())
    shape = q;
  return total;
}

SolveReport Statics::relax(const CableModel& model)
{
  SolveReport total;
  NodeField& q = trial_.q;
  // First step: the mean load per metre moves a free tether by FIRST_MOVE of its length.
  const double tau_0 = FIRST_MOVE * model.length() / (model.forceScale() / model.length());
  double tau = tau_0;
  int iterations_left = options_.max_iterations;
  while (iterations_left > 0)
  {
    start_ = q;
    const bool is_newton = tau >= NEWTON_TAU * tau_0;
    const SolveReport report = flow(model, is_newton ? 0.0 : 1.0 / tau, iterations_left);
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
    if (is_newton)
      return total;
    if (trial_.contact.friction != FrictionMode::SLIDING)
      acceptContact(model, trial_);
    tau *= report.iterations <= 4 ? 4.0 : 1.5;
  }
  total.status = SolveStatus::BUDGET_SPENT;
  return total;
}

ResidualSize Statics::assemble(const CableModel& model, double scale, const NewtonOptions& newton)
{
  model.assemble(trial_, TangentWeights{0.0, 0.0, 1.0}, residual_, tangent_);
  addMetric(model, scale, tangent_);
  addMetricForce(model, scale, trial_.q, start_, residual_);
  double reaction = 0.0;
  if (model.bodies().vehicle)
  {
    reaction = residual_.back().head<3>().norm();
    const AttachmentMotion at = attachmentMotion(trial_, trial_.q.size() - 1);
    const BodyResponse body = bodyResponse(*model.bodies().vehicle, model.sea(), 0.0, at, Rotation(), Wrench(),
                                           TangentWeights{0.0, 0.0, 1.0});
    residual_.back().head<3>() += body.force;
    tangent_.diagonal(model.elements()).topLeftCorner<3, 3>() += body.force_n;
  }
  return holdEnds(model, trial_.q, newton, steadyHeld(model), residual_, reaction);
}

SolveReport Statics::flow(const CableModel& model, double scale, int& iterations_left)
{
  SolveReport report;
  report.status = SolveStatus::NOT_CONVERGED;

  // On the way a rough solution of each step is enough; the last step has no metric and must be exact.
  NewtonOptions newton = options_.newton;
  if (scale > 0.0)
    newton.relative_tolerance = std::max(newton.relative_tolerance, 1e-4);
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
    previous = size.largest;
    holdEnds(steadyHeld(model), tangent_);
    ++report.iterations;
    --iterations_left;
    if (!std::isfinite(size.largest) || !tangent_.solvePivoted(residual_))
    {
      report.status = SolveStatus::SINGULAR;
      return report;
    }
    for (int i = 0; i < model.nodes(); ++i)
      trial_.q[i] -= residual_[i];
  }
}

}  // namespace tether_monitor::core
