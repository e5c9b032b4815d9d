#include "verification/robustness_checks.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <sstream>

#include "tether_monitor/core/assembly/element_assembly.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"

namespace tether_monitor::fuzz
{
namespace
{
using core::Vector3;

constexpr double TICK = 0.05;  // [s]

core::ElementParameters randomElement(RandomSource& dice)
{
  core::ElementParameters p;
  p.length = dice.scale(1e-3, 1e3);
  p.diameter = dice.scale(0.002, 0.3);
  p.area = 0.25 * M_PI * p.diameter * p.diameter;
  p.mass = p.area * dice.uniform(300.0, 8000.0);
  p.drag_normal = dice.uniform(0.0, 3.0);
  p.drag_tangential = dice.uniform(0.0, 0.5);
  p.added_mass = dice.uniform(0.0, 2.0);
  const double EA = dice.scale(1e3, 1e9);
  p.axial = {EA, dice.chance(0.5) ? 0.0 : dice.scale(1e-6, 1.0), dice.scale(1e-3, 1e4), 1e-5};
  p.bending_stiffness = dice.scale(1e-6, 1e5);
  p.compression = dice.chance(0.3) ? dice.uniform(0.0, 1e-3) : 0.0;
  p.natural_stretch = dice.chance(0.3) ? dice.uniform(1.0, 1.5) : 1.0;
  if (dice.chance(0.2))
    p.transport = {true,
                   dice.uniform(-1.0, 1.0),
                   dice.uniform(-1.0, 1.0),
                   dice.uniform(-5.0, 5.0),
                   dice.uniform(-5.0, 5.0),
                   dice.uniform(-1.0, 1.0),
                   dice.uniform(-1.0, 1.0)};
  return p;
}

core::Environment randomSea(RandomSource& dice)
{
  core::Environment sea;
  sea.water_density = dice.chance(0.9) ? 1025.0 : 0.0;
  if (dice.chance(0.5))
    sea.current = core::CurrentProfile(dice.uniform(0.0, 3.0) * dice.direction());
  if (dice.chance(0.3))
    sea.current = core::CurrentProfile({{0.0, dice.direction()}, {50.0, dice.direction()}});
  if (dice.chance(0.3))
  {
    core::WaveProperties wave;
    wave.length = dice.scale(10.0, 500.0);
    wave.amplitude = wave.length * dice.uniform(0.0, 1.0 / 15.0);
    wave.direction = dice.uniform(-3.0, 3.0);
    sea.waves.components = {wave};
  }
  if (dice.chance(0.3))
    sea.wind = dice.uniform(0.0, 40.0) * dice.direction();
  return sea;
}

// Slopes of any size and direction, none at all among them; two slopes alike; no chord.
core::CableState randomState(RandomSource& dice, int nodes, double length)
{
  core::CableState state(dice.uniform(0.0, 1e4), core::NodeField(nodes), Vector3::Zero());
  Vector3 r(dice.uniform(-1e4, 1e4), dice.uniform(-1e4, 1e4), dice.chance(0.3) ? 0.0 : dice.uniform(-1e4, 10.0));
  for (int i = 0; i < nodes; ++i)
  {
    const double stretch = dice.chance(0.1)   ? 0.0
                           : dice.chance(0.2) ? dice.scale(1e-9, 10.0)
                                              : dice.uniform(0.9, 1.1);
    state.q[i] << r, stretch * dice.direction();
    if (!dice.chance(0.1))
      r += dice.uniform(0.5, 1.5) * length * dice.direction();
    const double speed = dice.chance(0.2) ? 0.0 : dice.scale(1e-9, 1e3);
    for (int k = 0; k < 6; ++k)
    {
      state.v[i][k] = speed * dice.uniform(-1.0, 1.0);
      state.a[i][k] = 10.0 * speed * dice.uniform(-1.0, 1.0);
    }
  }
  return state;
}

// Largest difference over the size.
template <typename A, typename B>
double difference(const A& a, const B& b)
{
  const double scale = std::max(a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff());
  return scale > 0.0 ? (a - b).cwiseAbs().maxCoeff() / scale : 0.0;
}

// The ends of a tether that somebody moves: walks, teleports, reversals, stops.
class Mover
{
 public:
  Mover(RandomSource& dice, const core::SteadyEnds& ends, double length)
    : dice_(dice), length_(length), vessel_{ends.vessel, ends.velocity}, vehicle_{ends.vehicle, ends.velocity}
  {
  }
  void step(double dt)
  {
    move(vessel_, dt);
    move(vehicle_, dt);
  }
  monitor::EndTargets targets() const { return {vessel_, vehicle_}; }

 private:
  void move(core::EndMotion& end, double dt)
  {
    const double event = dice_.uniform(0.0, 1.0);
    if (event < 0.01)
      end.position += dice_.scale(0.01, 2.0) * length_ * dice_.direction();  // a teleport
    else if (event < 0.02)
      end.velocity = -end.velocity;
    else if (event < 0.03)
      end.velocity.setZero();
    else if (event < 0.06)
      end.velocity = dice_.scale(0.01, 20.0) * dice_.direction();
    else if (event < 0.062)
      end.position = vessel_.position;  // no chord
    end.position += dt * end.velocity;
  }

  RandomSource& dice_;
  double length_;
  core::EndMotion vessel_, vehicle_;
};

std::string describe(const RandomTether& t)
{
  std::ostringstream text;
  text.precision(17);
  text << "length " << t.tether.length << ", diameter " << t.tether.diameter << ", mass "
       << t.tether.mass_per_length << ", EA " << t.tether.axial_stiffness << ", EI " << t.tether.bending_stiffness
       << ", body " << t.bodies.vehicle.has_value();
  return text.str();
}

std::string fault(const monitor::TetherEstimate& e)
{
  if (e.status == monitor::Status::INVALID)
    return e.reason == monitor::Reason::NONE ? "INVALID without a reason" : "";
  bool finite = std::isfinite(e.vessel_tension) && std::isfinite(e.vehicle_tension) &&
                std::isfinite(e.max_tension) && std::isfinite(e.min_tension) && !std::isnan(e.min_bend_radius);
  for (std::size_t i = 0; i < e.stations.s.size(); ++i)
    finite = finite && e.stations.position[i].allFinite() && std::isfinite(e.stations.tension[i]);
  return finite ? "" : "a number that is not finite in a valid estimate";
}
}  // namespace

std::string checkElement(RandomSource& dice)
{
  constexpr int MOST = 2 * core::kernel::BLOCK + 1;
  constexpr double ROUNDING = 1e-8;  // of sums whose parts cancel
  const int count = 1 + static_cast<int>(dice.uniform(0.0, MOST));
  core::ElementAssembler field(count);
  double length = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const core::ElementParameters p = randomElement(dice);
    field.set(i, p);
    length = std::max(length, p.length);
  }
  const core::EnvironmentModel sea(randomSea(dice));
  const core::CableState state = randomState(dice, count + 1, length);
  const core::TangentWeights weights{1.0, dice.scale(1e-5, 1.0), dice.scale(1e-10, 1.0)};

  core::NodeField reference;
  for (const core::kernel::Kernel* kernel : core::kernel::available())
    for (const core::TangentKind kind : {core::TangentKind::SYMMETRIC, core::TangentKind::COMPLETE})
    {
      core::NodeField residual(count + 1);
      core::BlockTridiagonal tangent(count + 1);
      field.assemble(*kernel, sea, state, weights, kind, residual, tangent);
      for (int i = 0; i <= count; ++i)
      {
        const bool finite = residual[i].allFinite() && tangent.diagonal(i).allFinite() &&
                            (i == count || (tangent.upper(i).allFinite() && tangent.lower(i).allFinite()));
        if (!finite)
          return std::string(kernel->name) + ": residual or tangent of node " + std::to_string(i) +
                 " is not finite";
        if (!reference.empty() && difference(residual[i], reference[i]) > ROUNDING)
          return std::string(kernel->name) + ": residual differs by " +
                 std::to_string(difference(residual[i], reference[i])) + " at node " + std::to_string(i);
      }
      if (reference.empty())
        reference = residual;
    }
  return "";
}

std::string checkTether(RandomSource& dice)
{
  const RandomTether t = arbitraryTether(dice);
  monitor::Config config;
  config.tether = t.tether;
  config.environment = t.sea;
  config.elements = 2 + static_cast<int>(dice.uniform(0.0, 30.0));
  if (t.bodies.vehicle)
  {
    config.vehicle_mode = monitor::VehicleMode::FREE;
    config.vehicle_body = *t.bodies.vehicle;
  }
  config.solver.max_iterations = 100;
  try
  {
    monitor::TetherEstimator estimator(config);
    Mover mover(dice, t.ends, t.tether.length);
    double time = 0.0;
    estimator.begin(time, mover.targets());
    const int ticks = 10 + static_cast<int>(dice.uniform(0.0, 30.0));
    for (int k = 0; k < ticks; ++k)
    {
      time += TICK;
      mover.step(TICK);
      monitor::EndTargets targets = mover.targets();
      if (dice.chance(0.002))
        targets.vessel.position.x() = std::numeric_limits<double>::quiet_NaN();
      const long before = estimator.simulation().count.iterations;
      const std::string found = fault(estimator.advance(time, targets));
      if (!found.empty())
        return found + " at t = " + std::to_string(time) + " (" + describe(t) + ")";
      const long spent = estimator.simulation().count.iterations - before;
      if (spent > config.solver.max_iterations + config.solver.newton.max_iterations)
        return std::to_string(spent) + " iterations in a step (" + describe(t) + ")";
    }
  }
  catch (const std::exception& e)
  {
    return std::string("an exception: ") + e.what() + " (" + describe(t) + ")";
  }
  return "";
}

RestOutcome restOnSeabed(RandomSource& dice)
{
  const RandomTether t = tetherOnSeabed(dice);
  monitor::Config config;
  config.tether = t.tether;
  config.environment = t.sea;
  config.elements = 20 + static_cast<int>(dice.uniform(0.0, 60.0));
  monitor::TetherEstimator estimator(config);
  monitor::EndTargets ends;
  ends.vessel.position = t.ends.vessel;
  ends.vehicle.position = t.ends.vehicle;
  RestOutcome outcome;
  outcome.found = estimator.begin(0.0, ends).has_stations && estimator.simulation().last_solve.converged();
  if (!outcome.found)
    return outcome;
  const core::CableModel& model = estimator.simulation().model;
  core::CableState state = estimator.simulation().state;
  core::BoundaryConditions held;
  held.vessel = core::EndTrajectory::uniform(0.0, {state.q.front().head<3>(), Vector3::Zero()});
  held.vehicle = core::EndTrajectory::uniform(0.0, {state.q.back().head<3>(), Vector3::Zero()});
  core::StepperOptions options;
  options.step = 0.04;
  core::AdaptiveStepper stepper(model, options);
  const core::EndForces at_first = core::endForces(model, state);
  for (double time = 1.0; time <= 60.0; time += 1.0)
  {
    if (!stepper.advance(model, held, time, state).converged())
      return {true, INFINITY};
    const core::EndForces now = core::endForces(model, state);
    const double size = std::max(at_first.vessel.norm(), at_first.vehicle.norm());
    outcome.drift = std::max({outcome.drift, (now.vessel - at_first.vessel).norm() / size,
                              (now.vehicle - at_first.vehicle).norm() / size});
  }
  return outcome;
}
}  // namespace tether_monitor::fuzz
