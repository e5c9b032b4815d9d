#include "tether_monitor/core/solve/dynamic_relaxation.h"

#include <algorithm>

#include "tether_monitor/core/assembly/contact_summary.h"
#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/starting_shape.h"

namespace tether_monitor::core
{
namespace
{
constexpr double REST_MINUTE = 60.0;     // [s]
constexpr double WATCH_INTERVAL = 2.0;   // [s]
constexpr double LONGEST_WATCH = 600.0;  // [s]
constexpr double REST_DRIFT = 2e-3;      // of the end forces in a minute; 3e-3 is what a user is told
constexpr double STILL_DRIFT = 1e-6;     // likewise, in an interval of a tether that stands
constexpr double STANDING = 1e-5;        // [m/s]
constexpr int MOST_ITERATIONS = 100000;  // of one watch
constexpr double LEAST_FORCE = 1e-3;     // of the dry weight: a tether that weighs nothing has no end forces

CableModel withoutWavesAndFreeObstacles(const CableModel& model)
{
  std::vector<Obstacle> obstacles = model.environment().obstacles();
  for (Obstacle& obstacle : obstacles)
    obstacle.mass = 0.0;
  return model.withEnvironment(model.environment().withoutWaves().withObstacles(obstacles));
}

double change(const EndForces& a, const EndForces& b)
{
  return std::max((a.vessel - b.vessel).norm(), (a.vehicle - b.vehicle).norm());
}

double sizeOfForces(const DeployedCable& cable, const EndForces& forces)
{
  return std::max({forces.vessel.norm(), forces.vehicle.norm(), LEAST_FORCE * cable.forceScale()});
}

// A state at the time of another, and where that was.
void takeToStart(const CableState& start, const Vector3& velocity, CableState& state)
{
  const Vector3 travelled = (state.time - start.time) * velocity;
  for (NodeCoords& node : state.q)
    node.head<3>() -= travelled;
  for (Vector3& anchor : state.contact.seabed)
    anchor -= travelled;
  state.time = state.contact.time = start.time;
  state.obstacles = start.obstacles;
  state.step = 0.0;
}

void stop(CableState& state)
{
  for (NodeField* rate : {&state.v, &state.a, &state.algorithmic_acceleration})
    for (NodeCoords& x : *rate)
      x.setZero();
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

RestReport watchRest(const CableModel& model, const Vector3& velocity, double longest, CableState& state)
{
  const CableModel held = withoutWavesAndFreeObstacles(model);
  const CableState start = state;
  for (ObstacleMotion& obstacle : state.obstacles)
    obstacle.velocity.setZero();
  BoundaryConditions ends;
  ends.vessel = EndTrajectory::uniform(start.time, {state.q.front().head<3>(), velocity});
  ends.vehicle = EndTrajectory::uniform(start.time, {state.q.back().head<3>(), velocity});
  ends.clamps = state.clamps;
  AdaptiveStepper stepper(held, StepperOptions());
  RestReport rest;
  rest.solve.status = SolveStatus::NOT_AT_REST;
  const DeployedCable cable(held, state.deployment);
  EndForces reference = endForces(cable, state);
  double quiet_since = 0.0;
  for (double t = WATCH_INTERVAL; t <= longest && rest.solve.iterations < MOST_ITERATIONS; t += WATCH_INTERVAL)
  {
    const SolveReport report = stepper.advance(held, ends, start.time + t, state);
    rest.solve.addCost(report);
    rest.solve.residual = report.residual;
    rest.watched = t;
    if (!report.converged())
    {
      rest.solve.status = report.status;
      break;
    }
    const EndForces now = endForces(cable, state);
    const double moved = change(reference, now) / sizeOfForces(cable, now);
    const bool is_still = moved <= STILL_DRIFT && fastestAgainst(state, velocity) < STANDING;
    if (moved <= REST_DRIFT && (t - quiet_since >= REST_MINUTE || is_still))
    {
      rest.solve.status = SolveStatus::CONVERGED;
      rest.was_at_rest = quiet_since == 0.0;
      break;
    }
    if (moved > REST_DRIFT)
    {
      reference = now;
      quiet_since = t;
    }
  }
  if (rest.was_at_rest)
    state = start;
  else
    takeToStart(start, velocity, state);
  return rest;
}

SolveReport settleContact(SteadyStateSolver& solver, const CableModel& model, const SteadyEnds& ends,
                          CableState& state)
{
  SolveReport total;
  if (!touchesAnything(model, state) || ends.velocity.norm() > STANDSTILL)
    return total;
  const CableModel held = withoutWavesAndFreeObstacles(model);
  double left = LONGEST_WATCH;
  RestReport rest;
  while (!rest.was_at_rest && left > REST_MINUTE)
  {
    total.addCost(solver.settleFriction(held, ends, state));
    rest = watchRest(model, Vector3::Zero(), left, state);
    total.addCost(rest.solve);
    total.status = rest.was_at_rest || !rest.solve.converged() ? rest.solve.status : SolveStatus::NOT_AT_REST;
    total.residual = rest.solve.residual;
    if (!rest.solve.converged())
      break;
    left -= rest.watched;
    stop(state);
  }
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
  moving.clamps = ends.clamps;
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
  bool moves = false;
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
    NodeField solved = moved;
    report = solver.solveFrom(model, ends, solved);
    total.addCost(report);
    if (!report.converged())
    {
      CableState state(0.0, moved, ends.velocity, ends.deployment);
      state.clamps = ends.clamps;
      initializeContact(model, state);
      report = watchRest(model, ends.velocity, REST_MINUTE, state).solve;
      total.addCost(report);
    }
    total.status = report.status;
    moves = moves || report.status == SolveStatus::NOT_AT_REST;
    if (report.isUsable())
      shape = solved;
  }
  if (!total.converged() && moves)
    total.status = SolveStatus::NOT_AT_REST;
  return total;
}

}  // namespace tether_monitor::core
