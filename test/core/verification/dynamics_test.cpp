#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
BoundaryConditions prescribedEnds(const CableState& state)
{
  return {EndTrajectory::uniform(0.0, {state.q.front().head<3>(), Vector3::Zero()}),
          EndTrajectory::uniform(0.0, {state.q.back().head<3>(), Vector3::Zero()})};
}

// A state at rest whose accelerations satisfy the equations of motion.
CableState released(CableModel& model, const NodeField& shape)
{
  CableState state(0.0, shape, Vector3::Zero());
  GeneralizedAlpha starter(model);
  EXPECT_TRUE(starter.initializeAcceleration(model, prescribedEnds(state), state).converged());
  return state;
}

// Frequency [Hz] of a coordinate that starts at its largest, from the zero crossings of some periods.
template <typename Coordinate>
double measuredFrequency(CableModel& model, CableState state, double expected, Coordinate coordinate)
{
  StepperOptions options;
  options.step = 1.0 / (200.0 * expected);
  AdaptiveStepper stepper(model, options);
  const BoundaryConditions ends = prescribedEnds(state);
  double before = coordinate(state), first = 0.0, last = 0.0;
  int crossings = 0;
  for (int k = 1; k <= 2200 && crossings < 21; ++k)
  {
    const double t = k * options.step;
    if (!stepper.advance(model, ends, t, state).converged())
      return NAN;
    const double now = coordinate(state);
    if (before * now < 0.0)
    {
      last = t - options.step * now / (now - before);
      if (crossings++ == 0)
        first = last;
    }
    before = now;
  }
  return 0.5 * (crossings - 1) / (last - first);
}
}  // namespace

TEST(Swing, KeepsItsEnergy)
{
  CableProperties p = towCable();
  p.length = 20.0;
  p.axial_stiffness = 1.0e6;
  p.axial_damping = 0.0;
  CableModel model(p, 10, air());
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  ASSERT_TRUE(statics.solve(model, {{0, 0, 0}, {16, 0, 0}, {0, 0, 0}}, shape).converged());
  const DeployedCable cable(model);
  const double lowest = cable.energy(shape, NodeField(shape.size(), NodeCoords::Zero())).total();
  const Eigen::Matrix3d tilt = Eigen::AngleAxisd(0.25, Vector3::UnitX()).toRotationMatrix();
  for (NodeCoords& node : shape)
    node << tilt * node.head<3>(), tilt * node.tail<3>();

  CableState state = released(model, shape);
  const double start = cable.energy(state.q, state.v).total();
  const double swing = start - lowest;
  const double period = 2.0 * M_PI * std::sqrt(5.5 / 9.81);  // sag about 5.5 m: good enough to set the step
  StepperOptions options;
  options.step = period / 100.0;
  AdaptiveStepper stepper(model, options);
  const BoundaryConditions ends = prescribedEnds(state);
  double highest = start, lowest_side = 0.0;
  for (int k = 1; k <= 2000; ++k)
  {
    ASSERT_TRUE(stepper.advance(model, ends, k * options.step, state).converged());
    highest = std::max(highest, cable.energy(state.q, state.v).total());
    lowest_side = std::min(lowest_side, state.q[5].y());
  }
  EXPECT_LT(lowest_side, -0.5) << "it did swing through";
  EXPECT_LE((highest - start) / swing, 1e-6);
  EXPECT_GE(cable.energy(state.q, state.v).total(), start - 0.01 * swing);
}

TEST(Frequency, OfATautString)
{
  CableProperties p = towCable();
  p.length = 50.0;
  p.axial_stiffness = 1.0e6;
  Environment space = air();
  space.gravity = 0.0;
  CableModel model(p, 20, space);
  const double stretched = 50.5;
  NodeField shape(model.nodes());
  for (int i = 0; i < model.nodes(); ++i)
  {
    const double x = stretched * i / 20.0;
    shape[i] << x, 0.0, 0.01 * std::sin(M_PI * x / stretched), stretched / 50.0, 0.0,
        0.01 * M_PI / 50.0 * std::cos(M_PI * x / stretched);
  }
  const double lambda = stretched / p.length;
  const double tension = p.axial_stiffness * 0.5 * (lambda * lambda - 1.0) * lambda;
  const double exact = std::sqrt(tension / (p.mass_per_length / lambda)) / (2.0 * stretched);
  const double f =
      measuredFrequency(model, released(model, shape), exact, [](const CableState& s) { return s.q[10].z(); });
  EXPECT_NEAR(f, exact, 0.005 * exact);
}

TEST(Frequency, OfAHangingChainHeldBelow)
{
  // (T y')' + m w^2 y = 0 with T = T0 + m g x has the solutions J0, Y0 of b sqrt(T), b = 2 w / (g sqrt(m)).
  CableProperties p = towCable();
  p.length = 50.0;
  CableModel model(p, 20, air());
  const double m = p.mass_per_length, g = 9.81, T0 = 100.0, T1 = T0 + m * g * p.length;
  const auto miss = [&](double omega)
  {
    const double b = 2.0 * omega / (g * std::sqrt(m));
    return std::cyl_bessel_j(0, b * std::sqrt(T0)) * std::cyl_neumann(0, b * std::sqrt(T1)) -
           std::cyl_bessel_j(0, b * std::sqrt(T1)) * std::cyl_neumann(0, b * std::sqrt(T0));
  };
  double low = 0.1, high = 0.1;
  while (miss(low) * miss(high) > 0.0)
    high += 0.01;
  for (int i = 0; i < 60; ++i)
    (miss(low) * miss(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  const double omega = low, b = 2.0 * omega / (g * std::sqrt(m));
  const double ratio = std::cyl_bessel_j(0, b * std::sqrt(T0)) / std::cyl_neumann(0, b * std::sqrt(T0));
  const auto mode = [&](double T)
  { return std::cyl_bessel_j(0, b * std::sqrt(T)) - ratio * std::cyl_neumann(0, b * std::sqrt(T)); };

  const double stretch = (T0 * p.length + 0.5 * m * g * p.length * p.length) / p.axial_stiffness;
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  ASSERT_TRUE(statics.solve(model, {{0, 0, 0}, {0, 0, -p.length - stretch}, {0, 0, 0}}, shape).converged());
  for (int i = 0; i < model.nodes(); ++i)
  {
    const double T = T1 - m * g * model.mesh().arcLength(i), d = 1e-4 * T;
    shape[i][0] += 0.01 * mode(T);
    shape[i][3] += -0.01 * m * g * (mode(T + d) - mode(T - d)) / (2.0 * d);
  }
  const double exact = omega / (2.0 * M_PI);
  const double f =
      measuredFrequency(model, released(model, shape), exact, [](const CableState& s) { return s.q[12].x(); });
  EXPECT_NEAR(f, exact, 0.005 * exact);
}

TEST(Convergence, IsOfSecondOrderInTheStep)
{
  // A taut tow that starts to heave smoothly; force at the vessel end at a set of common times. The stiffness is
  // such that axial waves (0.95 s to and fro) are resolved by the steps: unresolved ones would hide the order.
  CableProperties p = towCable();
  p.axial_stiffness = 1.0e6;
  CableModel model(p, 20, Environment());
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  ASSERT_TRUE(statics.solve(model, {{0, 0, -5}, {-330, 0, -155}, {0, 0, 0}}, shape).converged());
  constexpr double HEAVE = 0.2;  // [m]: the tether stays taut
  const auto vessel = [](double t)
  {
    const double s = t < 6.0 ? t / 6.0 - std::sin(2.0 * M_PI * t / 6.0) / (2.0 * M_PI) : 1.0;
    const double ds = t < 6.0 ? (1.0 - std::cos(2.0 * M_PI * t / 6.0)) / 6.0 : 0.0;
    const double w = 2.0 * M_PI / 6.0;
    return EndMotion{{0, 0, -5 + HEAVE * s * std::sin(w * t)},
                     {0, 0, HEAVE * (ds * std::sin(w * t) + s * w * std::cos(w * t))}};
  };
  const auto history = [&](double h)
  {
    CableState state(0.0, shape, Vector3::Zero());
    StepperOptions options;
    options.step = h;
    options.newton.relative_tolerance = 1e-10;
    AdaptiveStepper stepper(model, options);
    std::vector<double> force;
    const long steps = std::lround(12.0 / h), sample = std::lround(0.4 / h);
    for (long k = 1; k <= steps; ++k)
    {
      const BoundaryConditions ends{EndTrajectory::between((k - 1) * h, vessel((k - 1) * h), k * h, vessel(k * h)),
                                    EndTrajectory::uniform(0.0, {{-330, 0, -155}, Vector3::Zero()})};
      EXPECT_TRUE(stepper.advance(model, ends, k * h, state).converged());
      if (k % sample == 0)
        force.push_back(endForces(model, state).vessel.norm());
    }
    return force;
  };
  const std::vector<double> fine = history(0.003125);
  const auto error = [&](double h)
  {
    const std::vector<double> force = history(h);
    double sum = 0.0;
    for (std::size_t i = 0; i < fine.size(); ++i)
      sum += (force[i] - fine[i]) * (force[i] - fine[i]);
    return std::sqrt(sum / fine.size());
  };
  const double coarse = error(0.025), half = error(0.0125);
  EXPECT_GE(std::log2(coarse / half), 1.9) << coarse << " N, " << half << " N";
}

TEST(TerminalVelocity, OfAHorizontalTetherThatFallsWithItsEnds)
{
  // Ends that sink at the terminal velocity of a falling horizontal tether carry nothing of its weight.
  const CableProperties p = towCable();
  const Environment sea;
  const double w = (p.mass_per_length - sea.water_density * p.displacedArea()) * sea.gravity;
  const double v = std::sqrt(w / (0.5 * sea.water_density * p.diameter * p.drag_normal));
  const EndForces forces = steadyForces(CableModel(p, 20, sea), {{0, 0, -100}, {400.004, 0, -100}, {0, 0, -v}});
  EXPECT_LT(std::abs(forces.vessel.z()), 0.01 * w * p.length);
}

}  // namespace tether_monitor::core
