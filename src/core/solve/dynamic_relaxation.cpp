#include "tether_monitor/core/solve/dynamic_relaxation.h"

#include <algorithm>

#include "tether_monitor/core/assembly/contact_summary.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/starting_shape.h"

namespace tether_monitor::core
{
namespace
{
CableModel withoutWavesAndFreeObstacles(const CableModel& model)
{
  std::vector<Obstacle> obstacles = model.environment().obstacles();
  for (Obstacle& obstacle : obstacles)
    obstacle.mass = 0.0;
  return model.withEnvironment(model.environment().withoutWaves().withObstacles(obstacles));
}

double fastestAgainst(const CableState& state, const Vector3& velocity)
{
  double fastest = 0.0;
  for (const NodeCoords& v : state.v)
    fastest = std::max(fastest, (v.head<3>() - velocity).norm());
  return fastest;
}

bool touchesAnything(const CableModel& model, const CableState& state)
{
  ContactSummary contact;
  contact.obstacles.resize(state.obstacles.size());
  summarizeContact(DeployedCable(model, state.deployment), state, contact);
  return contact.seabed_length > 0.0 ||
         std::any_of(contact.obstacles.begin(), contact.obstacles.end(),
                     [](const ContactSummary::ObstacleContact& touch) { return touch.total > 0.0; });
}
}  // namespace

SolveReport relaxFriction(const CableModel& model, CableState& state)
{
  constexpr double STRETCH = 2.0, LONGEST = 60.0;  // [s]
  constexpr double STILL = 2e-3;                   // [m/s]
  SolveReport total;
  if (!touchesAnything(model, state) || state.v.front().head<3>().norm() > STANDSTILL)
    return total;

  const CableModel held = withoutWavesAndFreeObstacles(model);
  const CableState start = state;
  for (ObstacleMotion& obstacle : state.obstacles)
    obstacle.velocity.setZero();
  AdaptiveStepper stepper(held, StepperOptions());
  BoundaryConditions rest;
  rest.vessel = EndTrajectory::uniform(start.time, {state.q.front().head<3>(), Vector3::Zero()});
  rest.vehicle = EndTrajectory::uniform(start.time, {state.q.back().head<3>(), Vector3::Zero()});
  for (double t = STRETCH; t <= LONGEST; t += STRETCH)
  {
    total = stepper.advance(held, rest, start.time + t, state);
    if (!total.converged() || fastestAgainst(state, Vector3::Zero()) < STILL)
      break;
  }
  state.time = state.contact.time = start.time;
  state.obstacles = start.obstacles;
  state.step = 0.0;
  for (NodeField* rate : {&state.v, &state.a, &state.algorithmic_acceleration})
    for (NodeCoords& x : *rate)
      x.setZero();
  return total;
}

SolveReport relaxDynamically(const CableModel& model, const SteadyEnds& ends, const NodeField& start,
                             NodeField& shape)
{
  constexpr double QUICK = 50.0, LONGEST = 1000.0;  // [s]: small steps at first, large ones later
  constexpr double STILL = 0.02, SLOW = 0.1;        // [m/s]
  const CableModel calm = withoutWavesAndFreeObstacles(model);
  CableState state(0.0, start, ends.velocity, ends.deployment);
  state.q.front().head<3>() = ends.vessel;
  if (!model.bodies().vehicle)
    state.q.back().head<3>() = ends.vehicle;
  initializeContact(calm, state);
  StepperOptions options;
  options.step = 0.1;
  options.spectral_radius = 0.0;
  AdaptiveStepper stepper(calm, options);
  options.step = 1.0;
  AdaptiveStepper later(calm, options);
  BoundaryConditions moving;
  moving.vessel = EndTrajectory::uniform(0.0, {ends.vessel, ends.velocity});
  moving.vehicle = EndTrajectory::uniform(0.0, {ends.vehicle, ends.velocity});
  SolveReport total;
  double stretch = 5.0;
  for (double t = stretch; t <= LONGEST; t += stretch)
  {
    const SolveReport report = (t <= QUICK ? stepper : later).advance(calm, moving, t, state);
    total.addCost(report);
    total.status = report.status;
    if (!report.converged())
      return total;
    const double fastest = fastestAgainst(state, ends.velocity);
    if (fastest < STILL || (fastest < SLOW && t + stretch > LONGEST))
    {
      shape = state.q;
      for (NodeCoords& node : shape)
        node.head<3>() -= t * ends.velocity;
      return total;
    }
    stretch = t < QUICK ? 5.0 : 50.0;
  }
  total.status = SolveStatus::NOT_CONVERGED;
  return total;
}

SolveReport findSteadyState(SteadyStateSolver& solver, const CableModel& model, const SteadyEnds& ends,
                            NodeField& shape)
{
  SolveReport total = solver.solve(model, ends, shape);
  // As the paper does it: let it move until it is steady. First from where the search ended, then from the curve.
  for (int attempt = 0; attempt < 2 && !total.converged(); ++attempt)
  {
    const bool from_search = attempt == 0 && total.status != SolveStatus::FOLDED_EQUILIBRIUM;
    const NodeField start =
        from_search ? solver.lastShape() : startingShape(DeployedCable(model, ends.deployment), ends);
    NodeField moved;
    SolveReport report = relaxDynamically(model, ends, start, moved);
    report.addCost(total);
    total = report;
    if (!report.converged())
      continue;
    shape = moved;
    report = solver.solveFrom(model, ends, moved);
    total.addCost(report);
    if (report.converged())
      shape = moved;
  }
  return total;
}

}  // namespace tether_monitor::core
