#include "verification/estimation_truths.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "tether_monitor/core/assembly/contact_assembly.h"
#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/monitor/ensemble/unknown_force.h"

namespace tether_monitor::bench
{
namespace
{
using core::EndMotion;
using core::Vector3;

constexpr double TRUE_STEP = 0.05;  // [s]

// Keeps a vehicle at a place or on its way, softly; the thrust has a memory of what it takes.
struct ThrustController
{
  double most = 1e9;  // [N]
  Vector3 integral = Vector3::Zero();

  Vector3 steer(const core::RigidBody& body, const EndMotion& wanted, const EndMotion& now, double dt)
  {
    constexpr double W = 0.4;
    const double mass = body.mass + body.added_mass.mean();
    const Vector3 off = wanted.position - now.position;
    const Vector3 before = integral;
    integral += mass * 0.15 * W * W * W * dt * off;
    const Vector3 thrust = mass * (W * W * off + 1.6 * W * (wanted.velocity - now.velocity)) + integral;
    if (thrust.norm() <= most)
      return thrust;
    integral = before;
    return most * thrust.normalized();
  }
};

// Around a circle of 12 m, begun gently.
EndMotion wayOf(const UncertainCase& c, double t)
{
  const Vector3& station = c.of.start.vehicle;
  if (c.manoeuvre <= 0.0)
    return {station, Vector3::Zero()};
  constexpr double RADIUS = 12.0, GENTLE = 30.0;
  const double rate = c.manoeuvre / RADIUS;
  const double angle = rate * (t < GENTLE ? 0.5 * t * t / GENTLE : t - 0.5 * GENTLE);
  const double speed = c.manoeuvre * std::min(t / GENTLE, 1.0);
  return {station + RADIUS * Vector3(std::cos(angle) - 1.0, std::sin(angle), 0.0),
          speed * Vector3(-std::sin(angle), std::cos(angle), 0.0)};
}

// The thrust of a pilot; one that pushes lets the vehicle go along x.
Vector3 thrustOf(const UncertainCase& c, ThrustController& pilot, const core::RigidBody& body,
                 const EndMotion& now, double t, double dt)
{
  constexpr double GENTLY = 6.0;  // [s]
  EndMotion wanted = wayOf(c, t);
  const double pushed = c.push == 0.0 ? 0.0 : std::clamp((t - c.changes_at) / GENTLY, 0.0, 1.0);
  if (pushed > 0.0)
  {
    wanted.position.x() = now.position.x();
    wanted.velocity.x() = now.velocity.x();
  }
  return pilot.steer(body, wanted, now, dt) + pushed * c.push * Vector3::UnitX();
}

// A first-order Gauss-Markov force, (E3).
class FastForce
{
 public:
  explicit FastForce(const TruthDraw& draw) : stddev_(draw.fast_stddev), generator_(draw.seed) {}

  Vector3 advance(double dt)
  {
    const double decay = std::exp(-dt / monitor::UnknownForce().fast_memory);
    const double x = normal_(generator_), y = normal_(generator_), z = normal_(generator_);
    force_ = decay * force_ + stddev_ * std::sqrt(1.0 - decay * decay) * Vector3(x, y, z);
    return force_;
  }

 private:
  double stddev_;  // [N]
  std::mt19937 generator_;
  std::normal_distribution<double> normal_;
  Vector3 force_ = Vector3::Zero();
};

EndMotion vesselAt(const Case& c, double t)
{
  constexpr double H = 1e-4;
  EndMotion end = c.vessel(t);
  end.velocity = (c.vessel(t + H).position - c.vessel(std::max(t - H, 0.0)).position) / (t >= H ? 2.0 * H : t + H);
  return end;
}

Case stationCase(const std::string& name)
{
  for (const Case& c : navigationCases())
    if (c.name == name)
      return c;
  throw std::runtime_error("no case " + name);
}

UncertainCase towed(const std::string& name)
{
  UncertainCase c;
  c.of = stationCase(name);
  c.of.bodies.vehicle->force.setZero();
  c.true_elements = 100;
  return c;
}

// The stern of a ship in a sea of 1.2 m, from 6 to 20 s: Pierson and Moskowitz's spectrum, risen from nothing.
EndMotion inIrregularSea(const Vector3& start, const Vector3& velocity, double t)
{
  constexpr double PEAK = 0.75, STEP = 0.035, SIZE = 0.3, RISE = 20.0;  // [rad/s, rad/s, m, s]
  const double risen = std::clamp(t / RISE, 0.0, 1.0);
  Vector3 off = Vector3::Zero();
  double variance = 0.0;
  for (int k = 0; k < 40; ++k)
  {
    const double f = 0.42 * PEAK + STEP * (k + 0.3 * std::sin(37.0 * k));
    const double density = std::pow(PEAK / f, 5) * std::exp(-1.25 * std::pow(PEAK / f, 4));
    const double phase = 2.4 * k * k;
    off += std::sqrt(2.0 * density) *
           Vector3(0.5 * std::cos(f * t + phase), 0.3 * std::cos(f * t + 2.0 * phase), std::sin(f * t + phase));
    variance += density;
  }
  const double share = risen * risen * (3.0 - 2.0 * risen) * SIZE / std::sqrt(variance);
  return {start + t * velocity + share * off, Vector3::Zero()};
}

UncertainCase thrusting(const std::string& name, const std::string& what)
{
  UncertainCase c;
  c.of = stationCase("G");
  c.of.name = name;
  c.of.what = what;
  c.is_towed = false;
  c.force_stddev = 300.0;
  return c;
}

double changedBy(const UncertainCase& c, double t)
{
  constexpr double RAMP = 10.0;
  return std::clamp((t - c.changes_at) / RAMP, 0.0, 1.0);
}

EndMotion centreOf(const core::CableState& state)
{
  return {state.q.back().head<3>(), state.v.back().head<3>()};
}
}  // namespace

std::vector<UncertainCase> uncertainCases()
{
  std::vector<UncertainCase> cases{towed("C"), towed("D")};
  UncertainCase irregular = towed("C");
  irregular.of.name = "I";
  irregular.of.what = "tow in an irregular sea";
  irregular.of.vessel = [start = irregular.of.start](double t)
  { return inIrregularSea(start.vessel, start.velocity, t); };
  cases.push_back(irregular);
  cases.push_back(thrusting("G", "keeps its station in a current"));
  UncertainCase rest = thrusting("R", "rests");
  rest.of.sea.current = core::CurrentProfile();
  rest.of.tether.mass_per_length = 0.6;
  rest.of.start.vehicle = {80.0, 0.0, -100.0};
  rest.of.vessel = [](double) { return EndMotion{Vector3::Zero(), Vector3::Zero()}; };
  rest.of.start.vessel = Vector3::Zero();
  cases.push_back(rest);
  UncertainCase way = thrusting("M", "manoeuvres at 0.5 m/s");
  way.of.sea.current = core::CurrentProfile(Vector3(0.2, 0.0, 0.0));
  way.manoeuvre = 0.5;
  way.force_stddev = 700.0;
  cases.push_back(way);
  UncertainCase slack = thrusting("S", "slack tether in a sheared current");
  slack.of.tether.length = 190.0;
  slack.of.sea.current = core::CurrentProfile({{0.0, {0.4, 0.1, 0.0}}, {120.0, {-0.1, 0.1, 0.0}}});
  cases.push_back(slack);
  return cases;
}

UncertainCase uncertainCase(const std::string& name)
{
  for (const UncertainCase& c : uncertainCases())
    if (c.of.name == name)
      return c;
  throw std::out_of_range("no case " + name);
}

std::vector<UncertainCase> changingCurrents()
{
  std::vector<UncertainCase> cases;
  for (UncertainCase& c : uncertainCases())
    if (c.of.name == "C" || c.of.name == "G")
    {
      c.true_elements = 50;
      c.current_change = {0.3, 0.0, 0.0};
      c.changes_at = 200.0;
      c.of.count_from = 500.0;
      c.of.duration = 700.0;
      cases.push_back(c);
    }
  return cases;
}

TruthDraw drawTruth(const UncertainCase& c, unsigned seed)
{
  std::mt19937 generator(seed);
  std::normal_distribution<double> normal;
  monitor::Config config;
  config.uncertainty = c.told;
  config.navigation.drag_stddev = c.vehicle_drag_stddev;
  config.tether = c.of.tether;
  const monitor::ParameterPrior prior = monitor::parameterPrior(config);
  monitor::ParameterVector p;
  for (int k = 0; k < monitor::PARAMETERS; ++k)
    p[k] = prior.stddev[k] * normal(generator);
  TruthDraw draw;
  draw.variation = monitor::variationOf(p, std::max(-c.of.start.vehicle.z(), 10.0));
  const double x = normal(generator), y = normal(generator), z = normal(generator);
  if (c.is_towed || c.reports_thrust)
  {
    config.navigation.force_stddev = c.force_stddev;
    const monitor::UnknownForce told = monitor::unknownForceOf(config);
    draw.force = told.slow_stddev * Vector3(x, y, z);
    draw.fast_stddev = told.fast_stddev;
    draw.seed = seed + 13;
  }
  draw.tension_bias = normal(generator);
  return draw;
}

Truth makeTruth(const UncertainCase& uncertain, const TruthDraw& draw)
{
  const Case& c = uncertain.of;
  Truth truth;
  truth.of = c;
  core::RigidBody body = *c.bodies.vehicle;
  body.force += draw.force;
  core::CableModel model(c.tether, uncertain.true_elements, c.sea);
  core::SteadyEnds start = c.start;
  start.deployment.variation = draw.variation;
  if (uncertain.payout)
    start.deployment.payout = uncertain.payout(0.0);
  core::SteadyStateSolver statics(model.nodes());
  core::NodeField shape;
  if (uncertain.is_towed)
    model = model.withBodies({std::nullopt, body});
  if (!statics.solve(model, start, shape).converged())
    throw std::runtime_error("case " + c.name + " has no steady state");
  core::CableState state(0.0, shape, c.start.velocity, start.deployment);
  core::initializeContact(model, state);
  ThrustController pilot;
  pilot.most = uncertain.most_thrust;
  if (!uncertain.is_towed)
  {
    const core::RigidBodyMotion motion = core::rigidBodyMotion(state, state.q.size() - 1, core::AttitudeState());
    pilot.integral =
        core::rigidBodyResidual(body, model.environment(), motion, core::Wrench(), {0.0, 0.0, 0.0}).force -
        core::endForces(model, state).vehicle;
    model = model.withBodies({std::nullopt, body});
  }
  core::StepperOptions options;
  options.step = TRUE_STEP;
  core::AdaptiveStepper stepper(model, options);
  const int count = static_cast<int>(std::lround(c.duration / truth.step));
  core::DeployedCable cable(model, state.deployment);
  FastForce fast(draw);
  Vector3 thrust = uncertain.is_towed ? Vector3(Vector3::Zero()) : pilot.integral;
  for (int i = 0; i <= count; ++i)
  {
    const double t = truth.timeOf(i);
    if (i > 0)
    {
      state.deployment.variation.current +=
          (changedBy(uncertain, t) - changedBy(uncertain, t - truth.step)) * uncertain.current_change;
      core::BoundaryConditions ends;
      ends.vessel = core::EndTrajectory::between(state.time, vesselAt(c, state.time), t, vesselAt(c, t));
      if (!uncertain.is_towed)
        thrust = thrustOf(uncertain, pilot, body, centreOf(state), t, truth.step);
      ends.vehicle_force = (uncertain.is_towed ? Vector3(Vector3::Zero()) : thrust) + fast.advance(truth.step);
      if (uncertain.payout)
        ends.payout =
            core::PayoutTrajectory::between(state.time, uncertain.payout(state.time), t, uncertain.payout(t));
      if (!stepper.advance(model, ends, t, state).converged())
        throw std::runtime_error("case " + c.name + " has no solution at " + std::to_string(t) + " s");
    }
    if (uncertain.payout)
      cable = core::DeployedCable(model, state.deployment);
    const core::EndForces forces = core::endForces(cable, state);
    truth.vessel.push_back(vesselAt(c, t));
    truth.vehicle.push_back(monitor::BodyState::ofNode(state, state.q.size() - 1, state.vehicle, Vector3::Zero()));
    if (uncertain.reports_thrust)
      truth.thrust.push_back({truth.vehicle.back().orientation.conjugate() * thrust, Vector3::Zero()});
    if (uncertain.payout)
      truth.payout.push_back(uncertain.payout(t));
    truth.vessel_tension.push_back(forces.vessel.norm());
    truth.vehicle_tension.push_back(forces.vehicle.norm());
  }
  return truth;
}

monitor::Config configFor(const UncertainCase& c, const Truth& truth, const Sensors& sensors)
{
  monitor::Config config = configFor(truth, Knowledge{}, monitor::VehicleMode::OBSERVED, sensors);
  config.navigation.force_stddev = c.force_stddev;
  config.navigation.drag_stddev = c.vehicle_drag_stddev;
  config.uncertainty = c.told;
  config.uncertainty.current = std::hypot(c.told.current, c.current_change.norm());
  if (c.reports_thrust)
    config.max_thrust = c.most_thrust;
  if (!c.is_towed)
  {
    config.tether.working_load = 2000.0;
    config.tether.breaking_load = 20000.0;
  }
  return config;
}

}  // namespace tether_monitor::bench
