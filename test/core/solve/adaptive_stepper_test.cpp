#include "tether_monitor/core/solve/adaptive_stepper.h"

#include <gtest/gtest.h>

#include "support/tethers.h"

namespace tether_monitor::core
{
class StepperTest : public ::testing::Test
{
 protected:
  StepperTest() : model(towCable(), 20, Environment())
  {
    SteadyStateSolver statics(model.nodes());
    NodeField shape;
    EXPECT_TRUE(statics.solve(model, {{0, 0, -5}, {-330, 0, -155}, {0, 0, 0}}, shape).converged());
    state = CableState(0.0, shape, Vector3::Zero());
  }
  BoundaryConditions towards(const Vector3& vehicle, double t_end) const
  {
    return {EndTrajectory::uniform(0.0, {{0, 0, -5}, Vector3::Zero()}),
            EndTrajectory::between(state.time, {state.q.back().head<3>(), Vector3::Zero()}, t_end,
                                   {vehicle, Vector3::Zero()})};
  }

  CableModel model;
  CableState state;
};

TEST_F(StepperTest, ASteadyStateStays)
{
  AdaptiveStepper stepper(model, StepperOptions());
  const NodeField before = state.q;
  ASSERT_TRUE(stepper.advance(model, towards({-330, 0, -155}, 10.0), 10.0, state).converged());
  EXPECT_DOUBLE_EQ(state.time, 10.0);
  for (std::size_t i = 0; i < before.size(); ++i)
    EXPECT_LT((state.q[i] - before[i]).norm(), 1e-6);
}

TEST_F(StepperTest, AnEndInThePastChangesNothing)
{
  AdaptiveStepper stepper(model, StepperOptions());
  EXPECT_EQ(stepper.advance(model, towards({-330, 0, -155}, 1.0), 0.0, state).steps, 0);
  EXPECT_EQ(state.time, 0.0);
}

TEST_F(StepperTest, GarbageLeavesTheStateAsItWas)
{
  AdaptiveStepper stepper(model, StepperOptions());
  const CableState before = state;
  const SolveReport report = stepper.advance(model, towards({NAN, 0, -155}, 0.05), 0.05, state);
  EXPECT_FALSE(report.converged());
  EXPECT_EQ(state.time, before.time);
  EXPECT_TRUE(state.allFinite());
  EXPECT_EQ(state.q[7], before.q[7]);
}

TEST_F(StepperTest, AFailedStepLeavesTheDeployedLengthAsItWas)
{
  for (const Scheme scheme : {Scheme::GENERALIZED_ALPHA, Scheme::ABARBANEL_ZWAS})
  {
    StepperOptions options;
    options.scheme = scheme;
    AdaptiveStepper stepper(model, options);
    const double built = model.length();
    BoundaryConditions drive = towards({-330, 0, -155}, 0.1);
    drive.payout = PayoutTrajectory::between(0.0, {built, 0.0, 0.0}, 0.1, {built + 0.2, 3.0, 0.0});
    CableState paid_out = state;
    ASSERT_TRUE(stepper.advance(model, drive, 0.1, paid_out).converged());
    ASSERT_NEAR(model.length(paid_out.deployment), built + 0.2, 1e-12);
    EXPECT_EQ(model.length(), built) << "the model holds no motion";

    const CableState before = paid_out;
    BoundaryConditions bad = drive;
    bad.payout = PayoutTrajectory::between(0.1, {built + 0.2, 3.0, 0.0}, 0.2, {built + 0.6, 3.0, 0.0});
    bad.vehicle = EndTrajectory::between(0.1, {Vector3::Constant(NAN), Vector3::Zero()}, 0.2, EndMotion());
    EXPECT_FALSE(stepper.advance(model, bad, 0.2, paid_out).converged());
    EXPECT_TRUE(hasSameElements(paid_out.deployment, before.deployment));
    EXPECT_EQ(paid_out.q[7], before.q[7]);

    // And what steps on is not another for the failure.
    AdaptiveStepper fresh(model, options);
    CableState other = before;
    const BoundaryConditions still{EndTrajectory::uniform(0.1, {{0, 0, -5}, Vector3::Zero()}),
                                   EndTrajectory::uniform(0.1, {{-330, 0, -155}, Vector3::Zero()})};
    ASSERT_TRUE(stepper.advance(model, still, 0.2, paid_out).converged());
    ASSERT_TRUE(fresh.advance(model, still, 0.2, other).converged());
    EXPECT_EQ(paid_out.q, other.q);
  }
}

TEST_F(StepperTest, TheBudgetHolds)
{
  StepperOptions options;
  options.max_iterations = 50;
  AdaptiveStepper stepper(model, options);
  // 10 km in one step.
  const SolveReport report = stepper.advance(model, towards({-10330, 0, -155}, 0.05), 0.05, state);
  EXPECT_LE(report.iterations, 50 + options.newton.max_iterations);
  EXPECT_TRUE(state.allFinite());
}

TEST_F(StepperTest, ASnapIsSubsteppedAndSurvived)
{
  AdaptiveStepper stepper(model, StepperOptions());
  // From slack to 1 m longer than the tether within half a second.
  const Vector3 far = Vector3(-330, 0, -150).normalized() * 401.0 + Vector3(0, 0, -5);
  const SolveReport report = stepper.advance(model, towards(far, 1.0), 1.0, state);
  EXPECT_TRUE(report.converged()) << describe(report.status);
  EXPECT_TRUE(state.allFinite());
}

TEST_F(StepperTest, SameInputSameBytes)
{
  CableState twin = state;
  AdaptiveStepper one(model, StepperOptions()), other(model, StepperOptions());
  const BoundaryConditions ends = towards({-335, 3, -150}, 2.0);
  ASSERT_TRUE(one.advance(model, ends, 2.0, state).converged());
  ASSERT_TRUE(other.advance(model, ends, 2.0, twin).converged());
  for (std::size_t i = 0; i < state.q.size(); ++i)
    EXPECT_EQ(state.q[i], twin.q[i]);
}

TEST(AdaptiveStepper, DoesNotSetOutForTheEndOfTime)
{
  CableModel model(towCable(), 4, Environment());
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  ASSERT_TRUE(statics.solve(model, {{0, 0, -5}, {-330, 0, -155}, {0, 0, 0}}, shape).converged());
  CableState state(-1e12, shape, Vector3::Zero());
  BoundaryConditions ends;
  ends.vessel = EndTrajectory::uniform(0.0, {{0, 0, -5}, Vector3::Zero()});
  ends.vehicle = EndTrajectory::uniform(0.0, {{-330, 0, -155}, Vector3::Zero()});
  AdaptiveStepper stepper(model, StepperOptions());
  EXPECT_EQ(stepper.advance(model, ends, 0.0, state).status, SolveStatus::ITERATION_LIMIT);
  EXPECT_EQ(state.time, -1e12);
}

}  // namespace tether_monitor::core
