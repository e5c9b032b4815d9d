#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/ball.h"
#include "support/matrix_compare.h"
#include "support/tethers.h"
#include "tether_monitor/core/assembly/contact_summary.h"

namespace tether_monitor::core
{
namespace
{
BoundaryConditions resting(const CableState& state)
{
  return {EndTrajectory::uniform(state.time, {state.q.front().head<3>(), Vector3::Zero()}),
          EndTrajectory::uniform(state.time, {state.q.back().head<3>(), Vector3::Zero()})};
}

double kinetic(const CableModel& model, const CableState& state)
{
  return DeployedCable(model, state.deployment).energy(state.q, state.v).kinetic;
}

double wholeEnergy(const CableModel& model, const CableState& state)
{
  const DeployedCable cable(model, state.deployment);
  ContactSummary contact;
  contact.obstacles.resize(state.obstacles.size());
  summarizeContact(cable, state, contact);
  double energy = cable.energy(state.q, state.v).total() + contact.energy;
  for (std::size_t k = 0; k < state.obstacles.size(); ++k)
    energy += 0.5 * model.environment().obstacles()[k].mass * state.obstacles[k].velocity.squaredNorm();
  return energy;
}

CableProperties rope(double length)
{
  CableProperties p = towCable();
  p.length = length;
  p.diameter = 0.02;
  p.mass_per_length = 0.8;
  p.axial_stiffness = 1.0e6;
  p.axial_damping = 1.0e-3;
  return p;
}

}  // namespace

TEST(Contact, TangentIsTheDerivative)
{
  Environment sea;
  sea.seabed = Seabed();
  sea.seabed->depth = 10.0;
  sea.seabed->slope = {0.1, -0.05};
  sea.obstacles.push_back(ball(2.0, Vector3(6.0, 0.0, -8.5)));
  sea.obstacles.back().friction = 0.4;
  sea.obstacles.back().mass = 5.0;
  sea.obstacles.back().stiffness = 1e4;
  CableModel model(rope(12.0), 4, sea);
  const DeployedCable cable(model);
  NodeField shape(5);
  for (int i = 0; i < 5; ++i)
    shape[i] << 3.0 * i, 0.2 * i, -10.0 - 0.05 * i + (i == 2 ? 4.0 : 0.0) - 0.3 * i, 1.0, 0.05, 0.0;
  CableState state(0.0, shape, Vector3(0.3, -0.2, -0.1));
  initializeContact(model, state);
  for (Vector3& place : state.contact.seabed)
    place += Vector3(1e-4, 2e-4, 0.0);
  const TangentWeights w{0.0, 0.3, 1.0};
  NodeField r(5), hi(5), lo(5);
  BlockTridiagonal tangent(5);
  BorderedSystem border({true}, 5);
  for (NodeCoords& row : r)
    row.setZero();
  addContact(cable.contactScene(state), w, r, &tangent, &border);
  ASSERT_GT(r[1].norm(), 0.0) << "precondition: the floor is touched";
  ASSERT_GT(border.residual(0).norm(), 0.0) << "precondition: the ball is touched";
  const double h = 1e-7;
  const auto residual = [&](CableState s, NodeField& out)
  {
    BorderedSystem b({true}, 5);
    for (NodeCoords& row : out)
      row.setZero();
    addContact(cable.contactScene(s), w, out, nullptr, &b);
    return Vector3(b.residual(0));
  };
  double scale = 0.0;
  for (int n = 0; n < 5; ++n)
    scale = std::max(scale, tangent.diagonal(n).norm());
  for (int n = 0; n < 5; ++n)
    for (int c = 0; c < 6; ++c)
    {
      CableState up = state, down = state;
      up.q[n][c] += w.stiffness * h;
      up.v[n][c] += w.damping * h;
      down.q[n][c] -= w.stiffness * h;
      down.v[n][c] -= w.damping * h;
      const Vector3 slope = (residual(up, hi) - residual(down, lo)) / (2 * h);
      EXPECT_TRUE(matricesNear(tangent.diagonal(n).col(c), (hi[n] - lo[n]) / (2 * h), 1e-4 * scale));
      EXPECT_TRUE(matricesNear(Vector3(border.row(0, n).row(c).transpose()), slope, 1e-4 * scale));
    }
  for (int c = 0; c < 3; ++c)
  {
    CableState up = state, down = state;
    up.obstacles[0].position[c] += w.stiffness * h;
    up.obstacles[0].velocity[c] += w.damping * h;
    down.obstacles[0].position[c] -= w.stiffness * h;
    down.obstacles[0].velocity[c] -= w.damping * h;
    const Vector3 slope = (residual(up, hi) - residual(down, lo)) / (2 * h);
    EXPECT_TRUE(matricesNear(Vector3(border.diagonal(0).col(c)), slope, 1e-4 * scale));
    for (int n = 0; n < 5; ++n)
      EXPECT_TRUE(matricesNear(NodeCoords(border.column(0, n).col(c)), (hi[n] - lo[n]) / (2 * h), 1e-4 * scale));
  }
}

TEST(Seabed, ALaidTetherDoesNotCreep)
{
  Environment sea;
  sea.current = CurrentProfile(Vector3(0.0, 0.25, 0.0));
  sea.seabed = Seabed();
  sea.seabed->depth = 50.0;
  sea.seabed->slope = {0.0, 0.1};  // it would roll down without friction
  CableModel model(rope(60.0), 30, sea);
  NodeField shape(31);
  for (int i = 0; i <= 30; ++i)
    shape[i] << 2.0 * i, 0.0, -50.0 + 0.5 * 0.02, 1.0, 0.0, 0.0;
  CableState state(0.0, shape, Vector3::Zero());
  initializeContact(model, state);
  BoundaryConditions ends = resting(state);
  // Ends laid down with the rest: they sink as far as the rest does.
  AdaptiveStepper stepper(model, StepperOptions());
  ASSERT_TRUE(stepper.advance(model, ends, 20.0, state).converged());
  const CableState settled = state;
  ASSERT_TRUE(stepper.advance(model, ends, 620.0, state).converged());
  for (int i = 0; i <= 30; ++i)
    EXPECT_LT((state.q[i] - settled.q[i]).head<3>().norm(), 1e-3) << "node " << i << " in ten minutes";
  ContactSummary summary;
  summarizeContact(DeployedCable(model, state.deployment), state, summary);
  EXPECT_NEAR(summary.seabed_length, 60.0, 0.5);
}

TEST(Seabed, ATetherLiesOnItsContactDiameter)
{
  Environment sea;
  sea.seabed = Seabed();
  sea.seabed->depth = 50.0;
  CableProperties armoured = rope(60.0);
  armoured.contact_diameter = 0.3;
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -49.85};
  ends.vehicle = {59.9, 0.0, -49.85};
  const NodeField shape = steadyShape(CableModel(armoured, 30, sea), ends);
  // Its weight over the stiffness of the floor is far less than a centimetre.
  EXPECT_NEAR(shape[15].z(), -50.0 + 0.15, 0.01);
}

TEST(Seabed, WithoutFrictionItRollsDownTheSlope)
{
  Environment sea;
  sea.seabed = Seabed();
  sea.seabed->depth = 50.0;
  sea.seabed->slope = {0.0, 0.1};
  sea.seabed->friction = 0.0;
  CableModel model(rope(60.0), 30, sea);
  NodeField shape(31);
  for (int i = 0; i <= 30; ++i)
    shape[i] << 2.0 * i, 0.0, -50.0 + 0.5 * 0.02, 1.0, 0.0, 0.0;
  CableState state(0.0, shape, Vector3::Zero());
  initializeContact(model, state);
  AdaptiveStepper stepper(model, StepperOptions());
  ASSERT_TRUE(stepper.advance(model, resting(state), 60.0, state).converged());
  EXPECT_GT(state.q[15].y(), 0.05);
}

TEST(Seabed, FallingOnTheFloorGainsNoEnergy)
{
  Environment sea = air();
  sea.seabed = Seabed();
  sea.seabed->depth = 1.0;
  sea.seabed->damping = 0.0;
  CableProperties p = rope(20.0);
  p.axial_damping = 1.0e-4;
  CableModel model(p, 20, sea);
  NodeField shape(21);
  for (int i = 0; i <= 20; ++i)
    shape[i] << i * std::cos(0.03), 0.0, i * std::sin(0.03), std::cos(0.03), 0.0, std::sin(0.03);
  CableState state(0.0, shape, Vector3(0.5, 1.0, 0.0));
  RigidBody light;
  light.mass = 0.1;
  light.inertia = Vector3::Ones();
  model = model.withBodies({light, light});
  initializeContact(model, state);
  GeneralizedAlpha starter(model);
  ASSERT_TRUE(starter.initializeAcceleration(model, BoundaryConditions(), state).converged());
  AdaptiveStepper stepper(model, StepperOptions());
  const auto energy = [&]
  {
    return wholeEnergy(model, state) + 9.81 * 0.1 * (state.q.front().z() + state.q.back().z()) +
           0.05 * (state.v.front().head<3>().squaredNorm() + state.v.back().head<3>().squaredNorm());
  };
  double before = energy();
  const double start = kinetic(model, state), fall = 0.8 * 20.0 * 9.81;
  for (int k = 1; k <= 100; ++k)
  {
    ASSERT_TRUE(stepper.advance(model, BoundaryConditions(), 0.02 * k, state).converged()) << k;
    const double now = energy();
    EXPECT_LT(now - before, 2e-3 * (start + fall)) << "at " << state.time;
    before = std::min(now, before);
  }
  EXPECT_LT(before, 0.9 * (start + fall)) << "friction and the scheme take some";
}

TEST(Capstan, TensionRatioIsTheExponentialOfTheAngle)
{
  // A rope over a fixed drum, drawn slowly at one end and held by a weight at the other: half a turn.
  Environment space = air();
  space.gravity = 0.0;
  Obstacle drum;
  drum.shape = ObstacleShape::CYLINDER;
  drum.size = {1.0, 2.0, 0.0};
  drum.orientation = Eigen::AngleAxisd(M_PI / 2.0, Vector3::UnitX());  // its axis along y
  drum.friction = 0.3;
  space.obstacles.push_back(drum);
  CableProperties p = rope(10.0 + M_PI);
  p.mass_per_length = 0.05;
  p.bending_stiffness = 0.0;
  const int N = 120;
  CableModel model(p, N, space);
  NodeField shape(N + 1);
  const double r = 1.01, arc = M_PI * r;
  for (int i = 0; i <= N; ++i)
  {
    const double s = p.length * i / N, a = s - 5.0;
    if (a < 0.0)
      shape[i] << -r, 0.0, a, 0.0, 0.0, 1.0;
    else if (a > arc)
      shape[i] << r, 0.0, arc - a, 0.0, 0.0, -1.0;
    else
      shape[i] << -r * std::cos(a / r), 0.0, r * std::sin(a / r), std::sin(a / r), 0.0, std::cos(a / r);
  }
  RigidBody weight;
  weight.mass = 20.0;
  weight.inertia = Vector3::Ones();
  weight.force = {0.0, 0.0, -200.0};
  weight.drag_area = {0.0, 0.0, 0.0};
  model = model.withBodies({std::nullopt, weight});
  CableState state(0.0, shape, Vector3::Zero());
  initializeContact(model, state);
  StepperOptions options;
  options.step = 0.02;
  AdaptiveStepper stepper(model, options);
  const Vector3 held = state.q[0].head<3>();
  const BoundaryConditions rest{EndTrajectory::uniform(0.0, {held, Vector3::Zero()}), {}};
  ASSERT_TRUE(stepper.advance(model, rest, 5.0, state).converged());
  // Draw the held end down: the weight rises, the rope slides over the drum.
  const BoundaryConditions draw{
      EndTrajectory::between(5.0, {held, Vector3::Zero()}, 7.0, {held - Vector3(0, 0, 0.1), Vector3(0, 0, -0.1)}),
      {}};
  ASSERT_TRUE(stepper.advance(model, draw, 7.0, state).converged());
  const BoundaryConditions on{EndTrajectory::uniform(7.0, {held - Vector3(0, 0, 0.1), Vector3(0, 0, -0.1)}), {}};
  double ratio = 0.0, mean = 0.0;
  int count = 0;
  for (double t = 7.2; t < 16.0; t += 0.2)
  {
    ASSERT_TRUE(stepper.advance(model, on, t, state).converged());
    const EndForces f = endForces(model, state);
    if (t < 10.0)
      continue;
    ratio += f.vessel.norm() / f.vehicle.norm();
    mean += f.vehicle.norm();
    ++count;
  }
  EXPECT_NEAR(mean / count, 200.0, 4.0);
  EXPECT_NEAR(ratio / count, std::exp(0.3 * M_PI), 0.03 * std::exp(0.3 * M_PI));
  ContactSummary summary;
  summary.obstacles.resize(1);
  summarizeContact(DeployedCable(model, state.deployment), state, summary);
  const EndForces f = endForces(model, state);
  EXPECT_NEAR(-summary.obstacles[0].force.z(), f.vessel.norm() + f.vehicle.norm(), 0.02 * f.vessel.norm())
      << "both legs press the drum";
  EXPECT_NEAR(summary.obstacles[0].s, 0.5 * p.length, 2.0);
}

TEST(Obstacle, OneWithAMassGetsTheMomentumThatTheTetherLoses)
{
  Environment space = air();
  space.gravity = 0.0;
  Obstacle buoy = ball(0.5, Vector3(5.0, 1.2, 0.0));
  buoy.mass = 10.0;
  buoy.friction = 0.2;
  buoy.stiffness = 1e6;
  space.obstacles.push_back(buoy);
  CableProperties p = rope(10.0);
  CableModel model(p, 20, space);
  RigidBody light;
  light.mass = 0.5;
  light.inertia = Vector3::Ones();
  model = model.withBodies({light, light});
  NodeField shape(21);
  for (int i = 0; i <= 20; ++i)
    shape[i] << 0.5 * i, 0.0, 0.1, 1.0, 0.0, 0.0;
  CableState state(0.0, shape, Vector3(0.2, 2.0, 0.0));
  initializeContact(model, state);
  GeneralizedAlpha starter(model);
  ASSERT_TRUE(starter.initializeAcceleration(model, BoundaryConditions(), state).converged());
  const DeployedCable cable(model, state.deployment);
  const auto tether = [&]
  {
    // Momentum of the consistent mass: m * integral of v, and the bodies.
    Vector3 sum = 0.5 * (state.v.front() + state.v.back()).head<3>();
    for (int i = 0; i < 20; ++i)
    {
      const double l = cable.element(i).length;
      sum += cable.element(i).mass * l *
             (0.5 * (state.v[i] + state.v[i + 1]).head<3>() + l / 12.0 * (state.v[i] - state.v[i + 1]).tail<3>());
    }
    return sum;
  };
  const Vector3 before = tether();
  StepperOptions options;
  options.step = 0.005;
  AdaptiveStepper stepper(model, options);
  ASSERT_TRUE(stepper.advance(model, BoundaryConditions(), 1.5, state).converged());
  const Vector3 got = 10.0 * state.obstacles[0].velocity;
  EXPECT_GT(got.norm(), 2.0) << "precondition: it was hit";
  EXPECT_LT((before - tether() - got).norm(), 1e-3 * got.norm());
}

TEST(Obstacle, AMovingOnePushesTheTetherAlong)
{
  Environment sea;
  Obstacle trawl;
  trawl.shape = ObstacleShape::CYLINDER;
  trawl.size = {0.6, 40.0, 0.0};
  trawl.position = Vector3(10.0, -2.0, -20.0);
  trawl.velocity = {0.0, 0.5, 0.0};
  sea.obstacles.push_back(trawl);
  CableModel model(rope(22.0), 44, sea);
  NodeField shape;
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -20.0};
  ends.vehicle = {20.0, 0.0, -20.0};
  SteadyStateSolver statics(model.nodes());
  ASSERT_TRUE(statics.solve(model, ends, shape).converged());
  CableState state(0.0, shape, Vector3::Zero());
  initializeContact(model, state);
  AdaptiveStepper stepper(model, StepperOptions());
  ASSERT_TRUE(stepper.advance(model, resting(state), 8.0, state).converged());
  EXPECT_NEAR(state.obstacles[0].position.y(), 2.0, 1e-9);
  EXPECT_NEAR(state.q[22].y(), 2.0 + 0.6 + 0.01, 0.05) << "the tether lies before the pile";
  EXPECT_GT(endForces(model, state).vessel.norm(), 0.0);
}

}  // namespace tether_monitor::core
