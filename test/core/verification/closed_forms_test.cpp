#include <gtest/gtest.h>

#include <cmath>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
RigidBody weight(double mass, double volume = 0.0)
{
  RigidBody body;
  body.mass = mass;
  body.volume = volume;
  body.inertia = Vector3::Ones();
  return body;
}

// Straight and taut along x, in space.
struct TautString
{
  explicit TautString(int elements, double stretch = 1.002, double length = 100.0)
  {
    CableProperties p = towCable();
    p.length = length;
    p.mass_per_length = 1.0;
    p.axial_stiffness = 1.0e6;
    p.axial_damping = 0.0;
    p.bending_stiffness = 1e-9;
    Environment space = air();
    space.gravity = 0.0;
    model.emplace(p, elements, space);
    NodeField shape(elements + 1);
    for (int i = 0; i <= elements; ++i)
      shape[i] << stretch * length * i / elements, 0.0, 0.0, stretch, 0.0, 0.0;
    state = CableState(0.0, shape, Vector3::Zero());
  }
  std::optional<CableModel> model;
  CableState state;
};
}  // namespace

TEST(ClosedForm, HangingStretch)
{
  CableProperties p = towCable();
  p.length = 300.0;
  p.axial_stiffness = 5.0e6;
  CableModel model(p, 20, air());
  model = model.withBodies({std::nullopt, weight(500.0)});
  const NodeField shape = steadyShape(model, SteadyEnds());
  const double w = 1.43 * 9.81, W = 500.0 * 9.81;
  const double stretch = (W * 300.0 + 0.5 * w * 300.0 * 300.0) / 5.0e6;
  // Green-Lagrange against Hooke: the strain of 0.15 % enters once more, three halves of it.
  EXPECT_NEAR(-shape.back().z() - 300.0, stretch, 0.005 * stretch);
}

namespace
{
// A bump u = f(s - c t) on coordinate `axis` runs 50 m; its top must be 50 elements further on, as high as before.
void expectPulseToTravel(TautString& string, int axis, double stretch, double c)
{
  const auto f = [](double x) { return 1e-3 * std::exp(-0.5 * x * x / 9.0); };
  const auto df = [&](double x) { return -x / 9.0 * f(x); };
  const auto ddf = [&](double x) { return (x * x / 81.0 - 1.0 / 9.0) * f(x); };
  for (int i = 0; i <= 100; ++i)
  {
    const double s = 1.0 * i - 25.0;
    string.state.q[i][axis] += f(s);
    string.state.q[i][axis + 3] += df(s);
    string.state.v[i][axis] = -c * df(s);  // d'Alembert
    string.state.v[i][axis + 3] = -c * ddf(s);
  }
  GeneralizedAlpha integrator(*string.model, 1.0);
  ASSERT_TRUE(integrator.initializeAcceleration(*string.model, heldAt(string.state), string.state).converged());
  const double duration = 50.0 / c;
  for (int k = 0; k < 500; ++k)
    ASSERT_TRUE(integrator.step(*string.model, heldAt(string.state), duration / 500, string.state).converged());
  const auto height = [&](int i) { return string.state.q[i][axis] - (axis == 0 ? stretch * i : 0.0); };
  int peak = 0;
  for (int i = 1; i < 100; ++i)
    if (height(i) > height(peak))
      peak = i;
  EXPECT_NEAR(peak, 75, 1);
  EXPECT_NEAR(height(75), 1e-3, 1e-5);
}
}  // namespace

TEST(ClosedForm, LongitudinalWaveSpeed)
{
  const double stretch = 1.002;
  TautString bar(100, stretch);
  expectPulseToTravel(bar, 0, stretch, std::sqrt(1.0e6 * 0.5 * (3.0 * stretch * stretch - 1.0)));
}

TEST(ClosedForm, TransverseWaveSpeed)
{
  const double stretch = 1.002;
  TautString string(100, stretch);
  // N / m: in unstretched metres a second.
  expectPulseToTravel(string, 2, stretch, std::sqrt(1.0e6 * 0.5 * (stretch * stretch - 1.0)));
}

TEST(ClosedForm, TerminalVelocityOfAFallingHorizontalCable)
{
  CableProperties p = towCable();
  p.length = 40.0;
  CableModel model(p, 10, Environment());
  RigidBody end = weight(1e-3);
  model = model.withBodies({end, end});
  NodeField shape(11);
  for (int i = 0; i <= 10; ++i)
    shape[i] << 4.0 * i, 0.0, -20.0, 1.0, 0.0, 0.0;
  CableState state(0.0, shape, Vector3::Zero());
  AdaptiveStepper stepper(model, StepperOptions());
  ASSERT_TRUE(stepper.advance(model, BoundaryConditions(), 15.0, state).converged());
  const double wet = (1.43 - 1025.0 * M_PI / 4.0 * 9e-4) * 9.81;
  const double terminal = std::sqrt(2.0 * wet / (1025.0 * 0.03 * 1.35));
  for (const NodeCoords& v : state.v)
    EXPECT_NEAR(-v.z(), terminal, 0.005 * terminal);
}

TEST(ClosedForm, TerminalVelocityOfACableThatSinksOnEnd)
{
  CableProperties p = towCable();
  p.length = 40.0;
  CableModel model(p, 10, Environment());
  model = model.withBodies({weight(1e-3), weight(1e-3)});
  NodeField shape(11);
  for (int i = 0; i <= 10; ++i)
    shape[i] << 0.0, 0.0, -20.0 - 4.0 * i, 0.0, 0.0, -1.0;
  CableState state(0.0, shape, Vector3::Zero());
  AdaptiveStepper stepper(model, StepperOptions());
  ASSERT_TRUE(stepper.advance(model, BoundaryConditions(), 20.0, state).converged());
  const double wet = (1.43 - 1025.0 * M_PI / 4.0 * 9e-4) * 9.81;
  const double terminal = std::sqrt(2.0 * wet / (1025.0 * 0.03 * 0.12566));
  EXPECT_NEAR(-state.v[5].z(), terminal, 0.01 * terminal);
}

// "Reversal of exposure": a body at rest in a stream is the body that moves through still water.
TEST(ReversedExposure, SameShapeAndForcesAtRestInTheStream)
{
  RigidBody body = weight(1030.44, 1030.44 / 1025.0);
  body.drag_area = Vector3::Constant(0.387);
  body.force = {-1000.0, 0.0, 0.0};
  EndForces forces[2];
  NodeField shapes[2];
  for (int k = 0; k < 2; ++k)
  {
    Environment sea;
    SteadyEnds ends;
    ends.vessel = {0.0, 0.0, -1.0};
    if (k == 0)
      ends.velocity = {3.0, 0.0, 0.0};
    else
      sea.current = CurrentProfile(Vector3(-3.0, 0.0, 0.0));
    CableModel model(towCable(), 40, sea);
    model = model.withBodies({std::nullopt, body});
    shapes[k] = steadyShape(model, ends);
    forces[k] = endForces(model, CableState(0.0, shapes[k], ends.velocity));
  }
  EXPECT_LT((forces[0].vessel - forces[1].vessel).norm(), 1e-6 * forces[0].vessel.norm());
  EXPECT_LT((forces[0].vehicle - forces[1].vehicle).norm(), 1e-6 * forces[0].vehicle.norm());
  for (int i = 0; i <= 40; ++i)
    EXPECT_LT((shapes[0][i] - shapes[1][i]).norm(), 1e-5);
}

TEST(Ageing, HydrostaticCompressionTakesBuoyancyAndDrag)
{
  // Hung straight down: the pull at the top is the dry weight less the buoyancy of the shrunk section.
  CableProperties p = towCable();
  p.length = 1000.0;
  p.hydrostatic_compression = 2e-4;
  CableModel model(p, 40, Environment());
  model = model.withBodies({std::nullopt, weight(200.0)});
  const NodeField shape = steadyShape(model, SteadyEnds());
  const EndForces f = endForces(model, CableState(0.0, shape, Vector3::Zero()));
  const double c = 2e-4, L = 1000.0;
  const double volume = M_PI / 4.0 * 9e-4 * (L - c * L * L + c * c * L * L * L / 3.0);
  const double expected = 9.81 * (200.0 + 1.43 * L - 1025.0 * volume);
  EXPECT_NEAR(f.vessel.norm(), expected, 1e-3 * expected);

  // In a stream: half the drag at half the diameter.
  Environment stream;
  stream.current = CurrentProfile(Vector3(0.5, 0.0, 0.0));
  double drag[2];
  for (int k = 0; k < 2; ++k)
  {
    p.length = 10.0;
    p.hydrostatic_compression = k * 5e-4;
    CableModel deep(p, 5, stream);
    SteadyEnds ends;
    ends.vessel = {0.0, 0.0, -995.0};
    ends.vehicle = {0.0, 0.0, -1005.01};
    const CableState state(0.0, steadyShape(deep, ends), Vector3::Zero());
    const EndForces ends_force = endForces(deep, state);
    drag[k] = ends_force.vessel.x() + ends_force.vehicle.x();
  }
  EXPECT_NEAR(drag[0], 0.5 * 1025.0 * 0.03 * 10.0 * 1.35 * 0.25, 0.01 * drag[0]);
  EXPECT_NEAR(drag[1] / drag[0], 0.5, 0.002);
}

TEST(Ageing, PermanentElongationMakesItLongerNotHeavier)
{
  CableProperties p = towCable();
  p.length = 100.0;
  p.permanent_elongation = 0.02;
  CableModel model(p, 20, air());
  model = model.withBodies({std::nullopt, weight(300.0)});
  const NodeField shape = steadyShape(model, SteadyEnds());
  const double W = 300.0 * 9.81, w = 1.43 * 9.81;
  const double stretch = (W * 100.0 + 0.5 * w * 1e4) / 6.75e7 * 1.02;
  EXPECT_NEAR(-shape.back().z(), 102.0 + stretch, 1e-4);
  const CableState state(0.0, shape, Vector3::Zero());
  EXPECT_NEAR(endForces(model, state).vessel.norm(), W + w * 100.0, 1e-4 * W);
  StationProfile stations(20);
  computeStations(DeployedCable(model, state.deployment), state, stations);
  EXPECT_NEAR(stations.strain[20], (W + 0.5 * w * 100.0) / 6.75e7, 2e-6)
      << "elastic strain, without the elongation";
  EXPECT_NEAR(stations.tension[20], W + 0.5 * w * 100.0, 1e-3 * W);
}

TEST(Wind, PushesTheEmergedPart)
{
  Environment sea;
  sea.wind = {0.0, 15.0, 0.0};
  CableProperties p = towCable();
  p.length = 20.0;
  CableModel model(p, 20, sea);
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, 10.0};
  ends.vehicle = {0.0, 0.0, -10.01};
  const CableState state(0.0, steadyShape(model, ends), Vector3::Zero());
  const EndForces f = endForces(model, state);
  EXPECT_NEAR(f.vessel.y() + f.vehicle.y(), 0.5 * 1.225 * 0.03 * 10.0 * 1.35 * 225.0, 0.1);
}

}  // namespace tether_monitor::core
