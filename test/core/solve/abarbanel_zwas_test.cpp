#include <gtest/gtest.h>

#include <cmath>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
// A straight bar in space: nothing but axial waves.
CableProperties bar()
{
  CableProperties p = towCable();
  p.length = 40.0;
  p.mass_per_length = 1.0;
  p.axial_stiffness = 1.0e6;
  p.axial_damping = 0.0;
  p.added_mass_normal = 0.0;
  p.bending_stiffness = 1e-9;
  return p;
}

Environment space()
{
  Environment sea = air();
  sea.gravity = 0.0;
  return sea;
}

// Largest axial velocity within `steps` of the scheme after a small random disturbance of a stretched bar. (Once
// it is slack a bar grows no further.)
double grown(bool free_end, double courant, int corrections, int steps)
{
  CableModel model(bar(), 10, space());
  RigidBody light;
  light.mass = 1e-6;
  light.inertia = Vector3::Ones();
  const double stretch = 1.001;
  light.force.x() = 1.0e6 * 0.5 * (stretch * stretch - 1.0) * stretch;
  if (free_end)
    model = model.withBodies({std::nullopt, light});
  NodeField shape(11);
  RandomElement random(7);
  for (int i = 0; i < 11; ++i)
    shape[i] << stretch * 4.0 * i, 0, 0, stretch + 1e-9 * random.uniform(-1, 1), 0, 0;
  CableState state(0.0, shape, Vector3::Zero());
  AbarbanelZwas scheme(model, corrections);
  BoundaryConditions ends;
  ends.vessel = EndTrajectory::uniform(0.0, {Vector3::Zero(), Vector3::Zero()});
  ends.vehicle = EndTrajectory::uniform(0.0, {shape[10].head<3>(), Vector3::Zero()});
  const double c = std::sqrt(1.0e6 * 0.5 * (3.0 * stretch * stretch - 1.0));  // dN/d|r'| of Green-Lagrange
  const double h = courant * 4.0 / c;
  double largest = 0.0;
  for (int k = 0; k < steps; ++k)
  {
    if (scheme.step(model, ends, h, state).status != SolveStatus::CONVERGED)
      return INFINITY;
    for (const NodeCoords& v : state.v)
      largest = std::max({largest, std::abs(v[0]), 4.0 * std::abs(v[3])});
  }
  return largest;
}
}  // namespace

class StabilityConstant : public ::testing::TestWithParam<std::pair<bool, int>>
{
};

// Just below the constant a disturbance stays, just above it grows without bound: the constants are sharp.
TEST_P(StabilityConstant, IsSharp)
{
  const auto [free_end, corrections] = GetParam();
  const double limit = free_end ? AbarbanelZwas::FREE_LIMIT : AbarbanelZwas::HELD_LIMIT;
  EXPECT_LT(grown(free_end, limit, corrections, 5000), 1e-4);
  EXPECT_GT(grown(free_end, 1.06 * limit, corrections, 5000), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Ends, StabilityConstant,
                         ::testing::Values(std::pair(false, 1), std::pair(false, 3), std::pair(true, 1),
                                           std::pair(true, 3), std::pair(true, 5)));

TEST(AbarbanelZwas, HundredTimesThePrintedConditionBlowsUp)
{
  // (49) of the paper with the tension for the stiffness: c is that of transverse waves.
  EXPECT_GT(grown(false, 1.0, 1, 200), 1.0);
}

class Corrections : public ::testing::TestWithParam<std::pair<int, double>>
{
};

// One printed correction leaves inertia 12 % wrong: the frequency of the bar's first axial mode shows it.
TEST_P(Corrections, SetTheFrequency)
{
  const auto [corrections, error] = GetParam();
  CableModel model(bar(), 10, space());
  NodeField shape(11);
  const double stretch = 1.001;
  for (int i = 0; i < 11; ++i)
  {
    const double x = 4.0 * i, k = M_PI / 40.0;
    shape[i] << stretch * x + 1e-4 * std::sin(k * x), 0, 0, stretch + 1e-4 * k * std::cos(k * x), 0, 0;
  }
  CableState state(0.0, shape, Vector3::Zero());
  AbarbanelZwas scheme(model, corrections);
  BoundaryConditions ends;
  ends.vessel = EndTrajectory::uniform(0.0, {Vector3::Zero(), Vector3::Zero()});
  ends.vehicle = EndTrajectory::uniform(0.0, {shape[10].head<3>(), Vector3::Zero()});
  const double c = std::sqrt(1.0e6 * 0.5 * (3.0 * stretch * stretch - 1.0)), h = 0.05 * 4.0 / c;
  double before = 1.0, first = 0.0, last = 0.0;
  int crossings = 0;
  for (int k = 0; k < 100000 && crossings < 7; ++k)
  {
    ASSERT_TRUE(scheme.step(model, ends, h, state).converged());
    const double now = state.q[5][0] - stretch * 20.0;
    if (before * now < 0.0)
    {
      last = state.time - h * now / (now - before);
      if (crossings++ == 0)
        first = last;
    }
    before = now;
  }
  const double measured = 0.5 * (crossings - 1) / (last - first), exact = c / 80.0;
  EXPECT_NEAR(measured / exact - 1.0, error, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Numbers, Corrections,
                         ::testing::Values(std::pair(0, 0.16), std::pair(1, -0.063), std::pair(2, 0.021),
                                           std::pair(3, -0.008), std::pair(8, 0.0)));

namespace
{
CableProperties softTow()
{
  CableProperties p = towCable();
  p.axial_stiffness = 2.0e6;
  p.axial_damping = 1.0e-3;
  return p;
}
}  // namespace

TEST(AbarbanelZwas, HeavePeakIsThatOfTheImplicitScheme)
{
  double peak[2];
  for (int k = 0; k < 2; ++k)
  {
    CableModel model(softTow(), 10, Environment());
    SteadyStateSolver statics(model.nodes());
    NodeField shape;
    SteadyEnds start;
    start.vessel = {0, 0, -5};
    start.vehicle = {-330, 0, -155};
    start.velocity = {1.5, 0, 0};
    ASSERT_TRUE(statics.solve(model, start, shape).converged());
    CableState state(0.0, shape, start.velocity);
    StepperOptions options;
    options.scheme = k == 0 ? Scheme::GENERALIZED_ALPHA : Scheme::ABARBANEL_ZWAS;
    AdaptiveStepper stepper(model, options);
    EndMotion vessel{start.vessel, start.velocity}, vehicle{start.vehicle, start.velocity};
    peak[k] = 0.0;
    for (double t = 0.05; t < 16.0; t += 0.05)
    {
      const double w = 2.0 * M_PI / 8.0, ramp = std::min(t / 8.0, 1.0), rate = t < 8.0 ? 1.0 / 8.0 : 0.0;
      const EndMotion up{{1.5 * t, 0, -5.0 + ramp * std::sin(w * t)},
                         {1.5, 0, ramp * w * std::cos(w * t) + rate * std::sin(w * t)}};
      const EndMotion on{{-330 + 1.5 * t, 0, -155}, {1.5, 0, 0}};
      const BoundaryConditions ends{EndTrajectory::between(t - 0.05, vessel, t, up),
                                    EndTrajectory::between(t - 0.05, vehicle, t, on)};
      ASSERT_TRUE(stepper.advance(model, ends, t, state).converged()) << t;
      vessel = up;
      vehicle = on;
      peak[k] = std::max(peak[k], endForces(model, state).vessel.norm());
    }
  }
  EXPECT_NEAR(peak[1], peak[0], 0.01 * peak[0]);
}

TEST(AbarbanelZwas, StaysStableOnTheSeabed)
{
  Environment sea;
  sea.seabed = Seabed();
  sea.seabed->depth = 10.0;
  CableProperties p = softTow();
  p.length = 30.0;
  p.axial_stiffness = 2e5;
  CableModel model(p, 10, sea);
  NodeField shape(11);
  for (int i = 0; i < 11; ++i)
    shape[i] << 3.0 * i, 0.0, -10.0 + 0.02 + 0.1 * std::sin(0.3 * i), 1.0, 0.0, 0.01 * std::cos(0.3 * i);
  CableState state(0.0, shape, Vector3::Zero());
  initializeContact(model, state);
  StepperOptions options;
  options.scheme = Scheme::ABARBANEL_ZWAS;
  AdaptiveStepper stepper(model, options);
  const BoundaryConditions rest{EndTrajectory::uniform(0.0, {shape[0].head<3>(), Vector3::Zero()}),
                                EndTrajectory::uniform(0.0, {shape[10].head<3>(), Vector3::Zero()})};
  ASSERT_TRUE(stepper.advance(model, rest, 5.0, state).converged());
  for (const NodeCoords& v : state.v)
    EXPECT_LT(v.norm(), 0.02);
}

TEST(AbarbanelZwas, SettlesToTheSteadyTowOfTheImplicitScheme)
{
  RigidBody body;
  body.mass = 200.0;
  body.volume = 0.15;
  body.inertia = {10, 20, 20};
  body.drag_area = {0.2, 0.2, 0.2};
  CableProperties p = softTow();
  p.length = 40.0;
  p.axial_stiffness = 2e5;
  const Vector3 velocity(1.5, 0, 0);
  EndForces forces[3];
  Vector3 place[3];
  for (int k = 0; k < 3; ++k)
  {
    CableModel model(p, 6, Environment());
    model = model.withBodies({std::nullopt, body});
    NodeField shape;
    SteadyStateSolver statics(model.nodes());
    SteadyEnds ends;
    ends.vessel = {0, 0, -1};
    ends.velocity = velocity;
    ASSERT_TRUE(statics.solve(model, ends, shape).converged());
    CableState state(0.0, shape, velocity);
    EndMotion vessel{ends.vessel, velocity};
    if (k < 2)
    {
      // Disturbed, then left alone.
      state.v.back()[1] = 0.5;
      StepperOptions options;
      options.scheme = k == 0 ? Scheme::GENERALIZED_ALPHA : Scheme::ABARBANEL_ZWAS;
      AdaptiveStepper stepper(model, options);
      ASSERT_TRUE(stepper.advance(model, {EndTrajectory::uniform(0.0, vessel), {}}, 150.0, state).converged());
    }
    forces[k] = endForces(model, state);
    place[k] = (state.q.back() - state.q.front()).head<3>();
  }
  for (int k = 0; k < 2; ++k)
  {
    EXPECT_LT((forces[k].vessel - forces[2].vessel).norm(), 1e-4 * forces[2].vessel.norm()) << k;
    EXPECT_LT((forces[k].vehicle - forces[2].vehicle).norm(), 1e-4 * forces[2].vehicle.norm()) << k;
    EXPECT_LT((place[k] - place[2]).norm(), 1e-4 * 40.0) << k;
  }
}

}  // namespace tether_monitor::core
