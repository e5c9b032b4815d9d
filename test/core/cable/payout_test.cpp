#include <gtest/gtest.h>

#include <cmath>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
RigidBody weight(double mass)
{
  RigidBody body;
  body.mass = mass;
  body.inertia = Vector3::Ones();
  return body;
}

BoundaryConditions heldAt(const Vector3& vessel, const Vector3& velocity, const PayoutTrajectory& payout)
{
  BoundaryConditions ends;
  ends.vessel = EndTrajectory::uniform(0.0, {vessel, velocity});
  ends.payout = payout;
  return ends;
}
}  // namespace

// Newton's second law for what hangs below the winch: T = (M + m L) (g - L''), whatever the mesh does meanwhile.
TEST(Payout, ARopeThatRunsOutCarriesWhatHangsLessItsAcceleration)
{
  CableProperties p = towCable();
  p.length = 20.0;
  p.axial_stiffness = 1.0e8;
  p.bending_stiffness = 1e-6;
  CableModel model(p, 8, air());
  model = model.withBodies({std::nullopt, weight(50.0)});
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  SteadyEnds start;
  ASSERT_TRUE(statics.solve(model, start, shape).converged());
  CableState state(0.0, shape, Vector3::Zero());
  StepperOptions options;
  options.step = 0.02;
  options.newton.relative_tolerance = 1e-10;
  AdaptiveStepper stepper(model, options);
  // Two smooth speed changes: faster over 4 s, then constant.
  const PayoutTrajectory speed_up =
      PayoutTrajectory::between(0.0, {20.0, 0.0, 0.0}, 4.0, {20.0 + 0.5 * 2.0 * 4.0, 2.0, 0.0});
  const double L_end = speed_up.at(4.0).length;
  const PayoutTrajectory run = PayoutTrajectory::between(4.0, {L_end, 2.0, 0.0}, 8.0, {L_end + 8.0, 2.0, 0.0});
  for (double t = 0.5; t < 8.0; t += 0.25)
  {
    const PayoutTrajectory& path = t <= 4.0 ? speed_up : run;
    ASSERT_TRUE(stepper.advance(model, heldAt(Vector3::Zero(), Vector3::Zero(), path), t, state).converged());
    const PayoutState now = path.at(t);
    const double expected = (50.0 + p.mass_per_length * now.length) * (9.81 - now.acceleration);
    // The acceleration begins and ends at once: the rope rings for a moment.
    const bool ringing = t <= 1.0 || (t > 4.0 && t <= 5.0);
    EXPECT_NEAR(endForces(model, state).vessel.norm(), expected, (ringing ? 2e-2 : 2e-3) * expected) << t;
    const double mass = DeployedCable(model, state.deployment).mass();
    EXPECT_NEAR(mass, p.mass_per_length * now.length, 1e-12 * mass) << "mass bookkeeping";
    EXPECT_NEAR(-state.q.back().z(), now.length * (1.0 + expected / 1.0e8), 2e-4 * now.length);
    EXPECT_NEAR(-state.v.back().z(), now.rate, 0.01);
  }
}

// A weight that circles on a rope in space: what runs out brings no angular momentum, so the turning slows by
// itself.
TEST(Payout, ACirclingWeightKeepsItsAngularMomentum)
{
  CableProperties p = towCable();
  p.length = 10.0;
  p.axial_stiffness = 1.0e7;
  p.bending_stiffness = 1e-6;
  Environment space = air();
  space.gravity = 0.0;
  CableModel model(p, 8, space);
  model = model.withBodies({std::nullopt, weight(5.0)});
  const double turning = 1.0, m = p.mass_per_length;
  const auto momentum = [&](double length) { return 5.0 * length * length + m * length * length * length / 3.0; };
  NodeField shape(9);
  for (int i = 0; i <= 8; ++i)
  {
    const double s = 1.25 * i;
    // Pull of what is further out, as strain.
    const double pull = turning * turning * (50.0 + 0.5 * m * (100.0 - s * s));
    shape[i] << s, 0.0, 0.0, 1.0 + pull / 1.0e7, 0.0, 0.0;
  }
  CableState state(0.0, shape, Vector3::Zero());
  for (int i = 0; i <= 8; ++i)
    state.v[i] << 0.0, turning * shape[i][0], 0.0, 0.0, turning, 0.0;
  StepperOptions options;
  options.step = 0.01;
  AdaptiveStepper stepper(model, options);
  const auto rest = [](const PayoutTrajectory& path) { return heldAt(Vector3::Zero(), Vector3::Zero(), path); };
  // Up to 0.5 m/s within 2 s, on for 8 s.
  ASSERT_TRUE(stepper
                  .advance(model, rest(PayoutTrajectory::between(0.0, {10.0, 0.0, 0.0}, 2.0, {10.5, 0.5, 0.0})),
                           2.0, state)
                  .converged());
  ASSERT_TRUE(stepper
                  .advance(model, rest(PayoutTrajectory::between(2.0, {10.5, 0.5, 0.0}, 10.0, {14.5, 0.5, 0.0})),
                           10.0, state)
                  .converged());
  const Vector3 r = state.q.back().head<3>(), v = state.v.back().head<3>();
  const double now = r.cross(v).z() / r.squaredNorm();
  const double expected = turning * momentum(10.0) / momentum(14.5);
  EXPECT_NEAR(now, expected, 0.01 * expected);
}

class PayoutUnderTow : public ::testing::TestWithParam<std::pair<double, double>>
{
};

TEST_P(PayoutUnderTow, EndsInTheSteadyStateOfTheNewLength)
{
  const auto [from, to] = GetParam();
  const double rate = to > from ? 1.0 : -1.0;
  const Vector3 velocity(3.0, 0.0, 0.0);
  RigidBody towed = weight(1030.44);
  towed.volume = 1030.44 / 1025.0;
  towed.drag_area = {0.387, 0.387, 0.387};
  towed.added_mass = Vector3::Constant(137.39);
  towed.force = {-1000.0, 0.0, 0.0};
  const auto steady = [&](double length, NodeField& shape)
  {
    CableProperties p = towCable();
    p.length = length;
    CableModel model(p, 40, Environment());
    model = model.withBodies({std::nullopt, towed});
    SteadyStateSolver statics(model.nodes());
    SteadyEnds ends;
    ends.velocity = velocity;
    EXPECT_TRUE(statics.solve(model, ends, shape).converged());
    return model;
  };
  NodeField shape, expected;
  CableModel model = steady(from, shape);
  const CableModel target = steady(to, expected);
  CableState state(0.0, shape, velocity);
  AdaptiveStepper stepper(model, StepperOptions());
  const double ramp = 20.0;  // a winch that jerks makes waves of sqrt(EA m) times its change of speed
  const double run = std::abs(to - from) - ramp;  // at full speed; both ramps cover half of theirs
  double t = 0.0, length = from;
  double before = endForces(model, state).vessel.norm(), largest_jump = 0.0;
  const auto go = [&](double duration, double by, double rate_0, double rate_1)
  {
    const PayoutTrajectory path =
        PayoutTrajectory::between(t, {length, rate_0, 0.0}, t + duration, {length + by, rate_1, 0.0});
    const BoundaryConditions ends = heldAt(Vector3::Zero(), velocity, path);
    const int parts = static_cast<int>(std::round(duration / 0.1));
    for (int k = 1; k <= parts; ++k)
    {
      ASSERT_TRUE(stepper.advance(model, ends, t + k * duration / parts, state).converged()) << state.time;
      const double now = endForces(model, state).vessel.norm();
      largest_jump = std::max(largest_jump, std::abs(now - before));
      before = now;
      ASSERT_NEAR(DeployedCable(model, state.deployment).mass(), 1.43 * model.length(state.deployment), 1e-9);
    }
    t += duration;
    length += by;
  };
  go(ramp, 0.5 * ramp * rate, 0.0, rate);
  go(run, run * rate, rate, rate);
  go(ramp, 0.5 * ramp * rate, rate, 0.0);
  go(400.0, 0.0, 0.0, 0.0);
  const EndForces now = endForces(model, state);
  const EndForces then = endForces(target, CableState(0.0, expected, velocity));
  const Vector3 vessel = state.q.front().head<3>(), vehicle = state.q.back().head<3>();
  EXPECT_NEAR(now.vessel.norm(), then.vessel.norm(), 1e-3 * then.vessel.norm());
  EXPECT_NEAR(now.vehicle.norm(), then.vehicle.norm(), 1e-3 * then.vehicle.norm());
  EXPECT_LT((vehicle - vessel - (expected.back() - expected.front()).head<3>()).norm(), 1e-3 * to);
  EXPECT_LT(largest_jump, 0.03 * then.vessel.norm()) << "tension changes smoothly, at most that in 0.1 s";
}

INSTANTIATE_TEST_SUITE_P(Lengths, PayoutUnderTow,
                         ::testing::Values(std::pair(300.0, 400.0), std::pair(400.0, 300.0)));

TEST(Payout, WhatIsFixedToTheTetherKeepsItsDistanceFromTheVehicle)
{
  CableLayout layout;
  layout.attachments.push_back({"float", 60.0, 1.0, 0.01, 0.0});
  CableProperties p = towCable();
  p.length = 100.0;
  CableModel model(p, 20, Environment(), layout);
  const int node = model.lumpedAttachments()[0].node;
  Deployment deployment;
  deployment.payout = PayoutState{130.0, 1.0, 0.0};
  const DeployedCable cable(model, deployment);
  EXPECT_NEAR(cable.arcLength(node), 90.0, 1e-9);
  EXPECT_NEAR(cable.arcLength(model.elements()), 130.0, 1e-9);
  EXPECT_FALSE(cable.element(model.elements() - 1).transport.active);
  EXPECT_TRUE(cable.element(0).transport.active);
  EXPECT_TRUE(model.canRepresentLength(50.0));
  EXPECT_FALSE(model.canRepresentLength(40.0)) << "the float would come aboard";
  EXPECT_NEAR(cable.mass(), 1.43 * 130.0 + 1.0, 1e-9);
}

}  // namespace tether_monitor::core
