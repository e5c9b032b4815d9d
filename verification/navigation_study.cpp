#include "verification/navigation_study.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "tether_monitor/core/assembly/contact_assembly.h"

namespace tether_monitor::bench
{
namespace
{
using core::EndMotion;
using core::Vector3;

constexpr int TRUE_ELEMENTS = 40;
constexpr double TRUE_STEP = 0.025;  // [s]

// Keeps a vehicle at a place, softly; the thrust has a memory of what it takes.
struct Pilot
{
  Vector3 station, integral = Vector3::Zero();

  core::Wrench steer(const core::RigidBody& body, const monitor::BodyState& now, double dt)
  {
    constexpr double W = 0.4;
    const double mass = body.mass + body.added_mass.mean();
    const Vector3 off = station - now.position;
    integral += mass * 0.15 * W * W * W * dt * off;
    const Vector3 force = mass * (W * W * off - 1.6 * W * now.velocity) + integral;
    return {now.orientation.conjugate() * force, Vector3::Zero()};
  }
};

Case stationKeeping()
{
  Case c;
  c.name = "G";
  c.what = "vehicle keeps its station 120 m down, near-neutral tether, vessel drifts and heaves";
  c.tether.length = 150.0;
  c.tether.diameter = 0.017;
  c.tether.mass_per_length = 0.24;
  c.tether.axial_stiffness = 4e6;
  c.tether.axial_damping = 1e-3;
  c.tether.drag_normal = 1.2;
  c.tether.drag_tangential = 0.03;
  c.tether.working_load = 2000.0;
  c.tether.breaking_load = 20000.0;
  c.sea.current = core::CurrentProfile(Vector3(0.5, 0.0, 0.0));
  core::RigidBody body;
  body.mass = 400.0;
  body.volume = 400.0 / 1025.0;
  body.inertia = {40.0, 60.0, 60.0};
  body.added_mass = Vector3::Constant(200.0);
  body.drag_area = {0.6, 0.8, 0.9};
  body.rotational_drag = Vector3::Constant(200.0);
  c.bodies.vehicle = body;
  c.duration = 400.0;
  c.count_from = 60.0;
  c.start = {{0, 0, -2}, {40, 0, -120}, {0, 0, 0}};
  c.vessel = [](double t)
  {
    const double drift = 2.0 * M_PI / 90.0, w = 2.0 * M_PI / 7.0, s = std::min(t / 14.0, 1.0);
    return EndMotion{
        {2.0 * s * std::sin(drift * t), 2.0 * s * std::sin(0.7 * drift * t), -2.0 + 0.5 * s * std::sin(w * t)},
        Vector3::Zero()};
  };
  return c;
}

bool hasPilot(const Case& c)
{
  return c.name == "G";
}

EndMotion vesselAt(const Case& c, double t)
{
  constexpr double H = 1e-4;
  EndMotion end = c.vessel(t);
  end.velocity = (c.vessel(t + H).position - c.vessel(std::max(t - H, 0.0)).position) / (t >= H ? 2.0 * H : t + H);
  return end;
}

monitor::BodyState bodyOf(const core::CableState& state)
{
  return monitor::BodyState::ofNode(state, state.q.size() - 1, state.vehicle, Vector3::Zero());
}

void note(const monitor::TetherEstimator& estimator, std::size_t i, Trail& trail)
{
  const monitor::TetherEstimate& e = estimator.estimate();
  trail.t.push_back(e.time);
  trail.index.push_back(i);
  trail.vessel_p05.push_back(e.vessel_tension_p05);
  trail.vessel_p95.push_back(e.vessel_tension_p95);
  trail.vehicle_p05.push_back(e.vehicle_tension_p05);
  trail.vehicle_p95.push_back(e.vehicle_tension_p95);
  trail.vessel_tension.push_back(e.vessel_tension);
  trail.vehicle_tension.push_back(e.vehicle_tension);
  trail.vessel_stddev.push_back(e.vessel_tension_stddev);
  trail.vehicle_stddev.push_back(e.vehicle_tension_stddev);
  trail.vehicle.push_back(e.vehicle.position);
  trail.vehicle_stddev_m.push_back(e.vehicle_position_stddev);
  trail.status.push_back(e.status);
  trail.reason.push_back(e.reason);
  for (const monitor::Alarm& alarm : estimator.alarms().alarms())
    trail.limit_alarm |= alarm.definition().name == "over_tension" && alarm.isAnnunciated();
}
}  // namespace

std::vector<Case> navigationCases()
{
  std::vector<Case> some;
  for (const Case& c : cases())
    if (c.name == "C" || c.name == "D")
      some.push_back(c);
  some.push_back(stationKeeping());
  return some;
}

Truth makeTruth(const Case& c, double duration, const Vector3& unmodelled)
{
  Truth truth;
  truth.of = c;
  core::RigidBody body = *c.bodies.vehicle;
  body.force += unmodelled;
  core::CableModel model(c.tether, TRUE_ELEMENTS, c.sea);
  core::SteadyEnds start = c.start;
  core::SteadyStateSolver statics(model.nodes());
  core::NodeField shape;
  if (!hasPilot(c))
    model = model.withBodies({std::nullopt, body});
  if (!statics.solve(model, start, shape).converged())
    throw std::runtime_error("case " + c.name + " has no steady state");
  core::CableState state(0.0, shape, c.start.velocity);
  core::initializeContact(model, state);
  Pilot pilot{start.vehicle};
  if (hasPilot(c))
  {
    pilot.integral = -core::steadyForce(body, model.environment(), start.vehicle, start.velocity) -
                     core::endForces(model, state).vehicle;
    model = model.withBodies({std::nullopt, body});
  }
  core::StepperOptions options;
  options.step = TRUE_STEP;
  core::AdaptiveStepper stepper(model, options);
  const int count = static_cast<int>(std::lround((duration > 0.0 ? duration : c.duration) / truth.step));
  for (int i = 0; i <= count; ++i)
  {
    const double t = truth.timeOf(i);
    core::Wrench thrust;
    if (hasPilot(c))
      thrust = pilot.steer(body, bodyOf(state), truth.step);
    if (i > 0)
    {
      core::BoundaryConditions ends;
      ends.vessel = core::EndTrajectory::between(state.time, vesselAt(c, state.time), t, vesselAt(c, t));
      ends.vehicle_thrust = thrust;
      if (!stepper.advance(model, ends, t, state).converged())
        throw std::runtime_error("case " + c.name + " has no solution at " + std::to_string(t) + " s");
    }
    const core::EndForces forces = core::endForces(model, state);
    truth.vessel.push_back(vesselAt(c, t));
    truth.vehicle.push_back(bodyOf(state));
    truth.vessel_tension.push_back(forces.vessel.norm());
    truth.vehicle_tension.push_back(forces.vehicle.norm());
    if (hasPilot(c))
      truth.thrust.push_back(thrust);
  }
  return truth;
}

monitor::Config configFor(const Truth& truth, const Knowledge& knowledge, monitor::VehicleMode mode,
                          const Sensors& sensors)
{
  monitor::Config config;
  config.tether = truth.of.tether;
  config.tether.length *= knowledge.length_factor;
  config.tether.working_load = 1.1 * *std::max_element(truth.vessel_tension.begin(), truth.vessel_tension.end());
  config.tether.breaking_load = 10.0 * config.tether.working_load;
  config.environment = truth.of.sea;
  config.elements = 10;
  config.vehicle_mode = mode;
  if (mode != monitor::VehicleMode::TRACKED)
  {
    config.vehicle_body = *truth.of.bodies.vehicle;
    config.vehicle_body.drag_area *= knowledge.drag_factor;
  }
  config.navigation.position_stddev = sensors.fix_stddev;
  config.navigation.latency = sensors.latency;
  config.vessel.position_stddev = sensors.satellite_stddev;
  config.invalid_timeout = 600.0;
  return config;
}

Trail observe(const Truth& truth, const monitor::Config& config, const Sensors& sensors,
              const std::function<void(const monitor::TetherEstimator&, std::size_t)>& look)
{
  std::mt19937 generator(sensors.seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> share;
  const auto noise = [&](double stddev)
  {
    const double x = normal(generator), y = normal(generator), z = normal(generator);
    return Vector3(stddev * Vector3(x, y, z));
  };
  monitor::TetherEstimator estimator(config);
  Trail trail;
  const auto every = [&](double interval) { return std::max<std::size_t>(1, std::lround(interval / truth.step)); };
  const std::size_t late = std::lround(sensors.latency / truth.step);
  const bool observed = config.vehicle_mode == monitor::VehicleMode::OBSERVED;
  for (std::size_t i = 0; i < truth.vessel.size(); ++i)
  {
    const double t = truth.timeOf(i);
    monitor::PoseMeasurement vessel;
    vessel.t = t;
    if (i % every(sensors.satellite_interval) == 0)
    {
      vessel.position = monitor::MeasuredVector::withStddev(
          truth.vessel[i].position + noise(sensors.satellite_stddev), Vector3::Constant(sensors.satellite_stddev));
      estimator.addVessel(vessel);
    }
    if (i % every(sensors.heave_interval) == 0 && observed)
    {
      const double height = truth.vessel[i].position.z() + sensors.heave_stddev * normal(generator);
      vessel.position =
          monitor::MeasuredVector::withStddev({0.0, 0.0, height}, Vector3::Constant(sensors.heave_stddev));
      vessel.position.setNotMeasured(0);
      vessel.position.setNotMeasured(1);
      estimator.addVessel(vessel);
    }
    if (!truth.thrust.empty() && config.vehicle_mode != monitor::VehicleMode::TRACKED)
      estimator.setThrust(t, truth.thrust[i]);
    if (!truth.payout.empty() && i % every(0.1) == 0)
      estimator.addPayout(t, truth.payout[i].length, truth.payout[i].rate);
    if (i >= late && (i - late) % every(sensors.fix_interval) == 0)
    {
      monitor::PoseMeasurement fix;
      fix.t = observed ? t : truth.timeOf(i - late);
      Vector3 position = truth.vehicle[i - late].position + noise(sensors.fix_stddev);
      const Vector3 away = noise(1.0).normalized() * (5.0 + 45.0 * share(generator));
      if (share(generator) < sensors.outliers)
        position += away;
      const bool is_sent = !sensors.fault || sensors.fault(truth.timeOf(i - late), position);
      fix.position = position;
      if (is_sent)
        estimator.addVehicle(fix);
    }
    if (observed && sensors.has_load_cell && i % every(0.1) == 0)
      estimator.addTension(
          t, truth.vessel_tension[i] * (1.0 + sensors.tension_stddev * normal(generator)) + sensors.tension_bias);
    if (i % every(1.0 / config.rate) != 0)
      continue;
    const double begin = cpuTime();
    estimator.tick(t);
    trail.cpu += cpuTime() - begin;
    if (look)
      look(estimator, i);
    note(estimator, i, trail);
  }
  if (const monitor::TetherEnsemble* ensemble = estimator.vehicle().ensemble())
    trail.innovations = ensemble->innovations();
  return trail;
}

Score score(const Truth& truth, const Trail& trail, double from, double to)
{
  Score s;
  double mean = 0.0, vehicle_mean = 0.0, square = 0.0, vehicle_square = 0.0, peak = 0.0, true_peak = 0.0;
  long valid = 0, total = 0, ok = 0, one = 0, two = 0;
  for (std::size_t i = 0; i < trail.t.size(); ++i)
  {
    if (trail.t[i] < from || trail.t[i] > to)
      continue;
    ++total;
    ok += trail.status[i] == monitor::Status::OK;
    if (trail.status[i] == monitor::Status::INVALID)
      continue;
    ++valid;
    const double error = trail.vessel_tension[i] - truth.vessel_tension[trail.index[i]];
    const double vehicle_error = trail.vehicle_tension[i] - truth.vehicle_tension[trail.index[i]];
    square += error * error;
    vehicle_square += vehicle_error * vehicle_error;
    mean += truth.vessel_tension[trail.index[i]];
    vehicle_mean += truth.vehicle_tension[trail.index[i]];
    peak = std::max(peak, trail.vessel_tension[i]);
    true_peak = std::max(true_peak, truth.vessel_tension[trail.index[i]]);
    one += std::abs(error) <= trail.vessel_stddev[i];
    two += std::abs(error) <= 2.0 * trail.vessel_stddev[i];
    s.mean_stddev += trail.vessel_stddev[i];
  }
  if (total == 0 || valid == 0)
    return s;
  const double n = static_cast<double>(valid);
  s.rms = std::sqrt(square / n) / (mean / n);
  s.vehicle_rms = std::sqrt(vehicle_square / n) / (vehicle_mean / n);
  s.peak = peak / true_peak - 1.0;
  s.within_1 = one / n;
  s.within_2 = two / n;
  s.mean_stddev /= mean;
  s.valid = n / static_cast<double>(total);
  s.ok = ok / static_cast<double>(total);
  return s;
}
}  // namespace tether_monitor::bench
