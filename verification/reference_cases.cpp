#include "verification/reference_cases.h"

#include <time.h>

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/assembly/contact_assembly.h"

namespace tether_monitor::bench
{
namespace
{
using core::EndMotion;
using core::Vector3;

// A smooth ramp of 20 s, its rate and its integral.
constexpr double RAMP = 20.0;
double ramp(double t)
{
  const double u = t / RAMP;
  return t < RAMP ? u - std::sin(2.0 * M_PI * u) / (2.0 * M_PI) : 1.0;
}
double rampRate(double t)
{
  return t < RAMP ? (1.0 - std::cos(2.0 * M_PI * t / RAMP)) / RAMP : 0.0;
}
double rampIntegral(double t)
{
  const double u = std::min(t / RAMP, 1.0);
  return RAMP * (0.5 * u * u + (std::cos(2.0 * M_PI * u) - 1.0) / (4.0 * M_PI * M_PI)) + std::max(0.0, t - RAMP);
}

EndMotion heave(double t, double period)
{
  const double w = 2.0 * M_PI / period, s = std::sin(w * t), c = std::cos(w * t);
  return {{0.0, 0.0, -5.0 + ramp(t) * s}, {0.0, 0.0, rampRate(t) * s + ramp(t) * w * c}};
}

EndMotion rest(const Vector3& place)
{
  return {place, Vector3::Zero()};
}

core::CableProperties cable(double length, double diameter, double mass, double EA)
{
  core::CableProperties p;
  p.length = length;
  p.diameter = diameter;
  p.mass_per_length = mass;
  p.axial_stiffness = EA;
  p.added_mass_normal = 1.0;
  p.working_load = 2.0e4;
  p.breaking_load = 6.0e4;
  return p;
}

core::CableProperties towCable(double tangential_drag)
{
  core::CableProperties p = cable(400.0, 0.030, 1.43, 6.75e7);
  p.drag_normal = 1.35;
  p.drag_tangential = tangential_drag;
  return p;
}

Case heaveTow()
{
  Case c;
  c.name = "A";
  c.what = "taut: tow from rest with a heaving vessel, both ends held";
  c.tether = towCable(0.12566);
  c.tether.axial_damping = 1.0e4 / 6.75e7;
  c.duration = 120.0;
  c.count_from = RAMP;
  c.start = {{0, 0, -5}, {-330, 0, -155}, {0, 0, 0}};
  const auto way = [](double t) { return EndMotion{{1.5 * rampIntegral(t), 0, 0}, {1.5 * ramp(t), 0, 0}}; };
  c.vessel = [=](double t)
  {
    EndMotion end = heave(t, 8.0);
    end.position += way(t).position;
    end.velocity += way(t).velocity;
    return end;
  };
  c.vehicle = [=](double t) { return EndMotion{way(t).position + Vector3(-330, 0, -155), way(t).velocity}; };
  return c;
}

Case lowTension()
{
  Case c;
  c.name = "B";
  c.what = "low tension: the vehicle end circles under a resting vessel";
  c.tether = cable(100.0, 0.012, 0.13, 1e6);
  c.tether.axial_damping = 1e-4;
  c.tether.drag_normal = 1.35;
  c.tether.drag_tangential = 0.12566;
  c.duration = 140.0;
  c.count_from = RAMP;
  c.start = {{0, 0, -5}, {65, 0, -45}, {0, 0, 0}};
  c.vessel = [](double) { return rest({0, 0, -5}); };
  c.vehicle = [](double t)
  {
    const double w = 2.0 * M_PI / 60.0, angle = w * rampIntegral(t), rate = w * ramp(t);
    return EndMotion{{60.0 + 5.0 * std::cos(angle), 5.0 * std::sin(angle), -45.0},
                     {-5.0 * rate * std::sin(angle), 5.0 * rate * std::cos(angle), 0.0}};
  };
  return c;
}

core::RigidBody towedBody(double drag_area, double aft)
{
  core::RigidBody body;
  body.mass = 1030.44;
  body.volume = 1030.44 / 1025.0;
  body.inertia = Vector3::Constant(165.0);
  body.added_mass = Vector3::Constant(137.39);
  body.drag_area = Vector3::Constant(drag_area);
  body.force = {-aft, 0.0, 0.0};
  return body;
}

Case bodyInHeave()
{
  Case c;
  c.name = "C";
  c.what = "free body under tow, heaving vessel";
  c.tether = towCable(0.04);
  c.bodies.vehicle = towedBody(0.387, 1000.0);
  c.duration = 200.0;
  c.count_from = 20.0;
  c.start = {{0, 0, -5}, {-390, 0, -70}, {3, 0, 0}};
  c.vessel = [](double t)
  {
    const double w = 2.0 * M_PI / 8.0, s = std::min(t / 16.0, 1.0), rate = t < 16.0 ? 1.0 / 16.0 : 0.0;
    return EndMotion{{3.0 * t, 0.0, -5.0 + s * std::sin(w * t)},
                     {3.0, 0.0, rate * std::sin(w * t) + s * w * std::cos(w * t)}};
  };
  c.reference_elements = 200;
  return c;
}

Case bodyInTurn()
{
  Case c;
  c.name = "D";
  c.what = "free body under tow, vessel turns back on a radius of 200 m";
  c.tether = towCable(0.04);
  c.bodies.vehicle = towedBody(0.60384, 0.0);
  c.duration = 400.0;
  c.count_from = 20.0;
  c.output = 0.2;
  c.start = {{0, 0, -5}, {-390, 0, -70}, {3, 0, 0}};
  c.vessel = [](double t)
  {
    constexpr double BEGIN = 60.0, RATE = 0.015, SPEED = 3.0, RADIUS = SPEED / RATE;
    const double turn = std::clamp((t - BEGIN) * RATE, 0.0, M_PI);
    const double after = std::max(0.0, t - BEGIN - M_PI / RATE);
    return EndMotion{{SPEED * std::min(t, BEGIN) + RADIUS * std::sin(turn) - SPEED * after,
                      RADIUS * (1.0 - std::cos(turn)), -5.0},
                     {SPEED * std::cos(turn), SPEED * std::sin(turn), 0.0}};
  };
  c.reference_elements = 200;
  c.reference_step = 0.01;
  return c;
}

Case snap()
{
  Case c;
  c.name = "E";
  c.what = "snap: slack and taut every 6 s";
  c.tether = cable(100.0, 0.012, 0.13, 5e6);
  c.tether.drag_normal = 1.2;
  c.tether.drag_tangential = 0.04;
  c.duration = 60.0;
  c.start = {{0, 0, -5}, {97.5, 0, -25}, {0, 0, 0}};
  c.vessel = [](double) { return rest({0, 0, -5}); };
  c.vehicle = [](double t)
  {
    const double w = 2.0 * M_PI / 6.0;
    return EndMotion{{97.5 + 0.7 * ramp(t) * std::sin(w * t), 0.0, -25.0},
                     {0.7 * (rampRate(t) * std::sin(w * t) + ramp(t) * w * std::cos(w * t)), 0.0, 0.0}};
  };
  c.reference_step = 0.0005;
  return c;
}

Case slackBight()
{
  Case c;
  c.name = "F";
  c.what = "slack bight in a current, heaving vessel";
  c.tether = towCable(0.04);
  c.tether.axial_damping = 1.0e4 / 6.75e7;
  c.tether.bending_stiffness = 50.0;
  c.sea.current = core::CurrentProfile(Vector3(-1.5, 0.0, 0.0));
  c.duration = 120.0;
  c.count_from = RAMP;
  c.start = {{0, 0, -5}, {-330, 0, -155}, {0, 0, 0}};
  c.vessel = [](double t) { return heave(t, 8.0); };
  c.vehicle = [](double) { return rest({-330, 0, -155}); };
  return c;
}
}  // namespace

double cpuTime()
{
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

std::vector<Case> cases()
{
  return {heaveTow(), lowTension(), bodyInHeave(), bodyInTurn(), snap(), slackBight()};
}

Record run(const Case& c, int elements, const core::StepperOptions& options, const core::kernel::Kernel* kernel)
{
  Record record;
  core::CableModel model = core::CableModel(c.tether, elements, c.sea).withBodies(c.bodies);
  if (kernel)
    model = model.withKernel(*kernel);
  core::NodeField shape;
  core::SteadyStateSolver statics(model.nodes());
  if (!statics.solve(model, c.start, shape).converged())
    return record;
  core::CableState state(0.0, shape, c.start.velocity);
  core::initializeContact(model, state);
  core::AdaptiveStepper stepper(model, options);
  const int count = static_cast<int>(std::lround(c.duration / c.output));
  // An advance() ends at the outputs and is no longer than a largest step.
  const int parts = std::max(1, static_cast<int>(std::lround(c.output / options.step)));
  const int skip = std::max(1, static_cast<int>(std::lround(options.step / c.output)));
  record.vessel.reserve(count);
  record.vehicle.reserve(count);
  for (int i = skip; i <= count; i += skip)
  {
    for (int part = 1; part <= parts; ++part)
    {
      const double t0 = state.time;
      const double t = i * c.output - (parts - part) * c.output / parts;
      core::BoundaryConditions ends;
      ends.vessel = core::EndTrajectory::between(t0, c.vessel(t0), t, c.vessel(t));
      if (c.vehicle)
        ends.vehicle = core::EndTrajectory::between(t0, c.vehicle(t0), t, c.vehicle(t));
      const double begin = cpuTime();
      const core::SolveReport report = stepper.advance(model, ends, t, state);
      record.times.push_back(cpuTime() - begin);
      record.cpu += record.times.back();
      record.iterations.push_back(report.iterations);
      record.total.addCost(report);
      record.worst_iterations = std::max(record.worst_iterations, report.iterations);
      record.worst_pieces = std::max(record.worst_pieces, report.steps + report.rejected);
      if (!report.converged())
        return record;
    }
    const core::EndForces forces = core::endForces(model, state);
    record.vessel.push_back(forces.vessel.norm());
    record.vehicle.push_back(forces.vehicle.norm());
  }
  record.complete = true;
  return record;
}

Deviation deviation(const Case& c, const std::vector<double>& record, const std::vector<double>& reference,
                    double output)
{
  const std::size_t every = reference.size() / record.size();
  double square = 0.0, mean = 0.0, peak = 0.0, reference_peak = 0.0;
  int samples = 0;
  for (std::size_t i = 0; i < record.size(); ++i)
  {
    const double truth = reference[(i + 1) * every - 1];
    if (static_cast<double>((i + 1) * every) * output <= c.count_from)
      continue;
    square += (record[i] - truth) * (record[i] - truth);
    mean += truth;
    peak = std::max(peak, record[i]);
    reference_peak = std::max(reference_peak, truth);
    ++samples;
  }
  return {std::sqrt(square / samples) / (mean / samples), std::abs(peak / reference_peak - 1.0)};
}
}  // namespace tether_monitor::bench
