#include "tether_monitor/core/assembly/clamped_end.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/matrix_compare.h"
#include "support/tethers.h"
#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::core
{
namespace
{
const ClampedEnd CLAMP{50.0, Vector3(0.6, 0.0, 0.8)};
}

TEST(ClampedEnd, ForceAndTangentAreDerivativesOfTheEnergy)
{
  const double h = 1e-6;
  for (const Vector3& slope : {Vector3(0.6, 0.0, 0.81), Vector3(1.0, 0.3, -0.2), Vector3(-0.5, 0.1, -0.9)})
    for (int i = 0; i < 3; ++i)
    {
      const Vector3 step = h * Vector3::Unit(i);
      EXPECT_NEAR(CLAMP.residual(slope)[i], (CLAMP.energy(slope + step) - CLAMP.energy(slope - step)) / (2 * h),
                  1e-7);
      EXPECT_TRUE(matricesNear(Vector3(CLAMP.tangent(slope).col(i)),
                               Vector3((CLAMP.residual(slope + step) - CLAMP.residual(slope - step)) / (2 * h)),
                               1e-6));
    }
  const ClampedEnd hinge{50.0, Vector3::Zero()};
  EXPECT_TRUE(hinge.residual(Vector3::UnitX()).isZero());
}

// A cantilever of little weight against Bernoulli's beam: deflection w L^4 / 8 EI, moment w L^2 / 2.
TEST(ClampedEnd, ACantileverBendsAsBernoullisBeam)
{
  CableProperties p = plainCable(2.0, 0.02, 0.05, 1e6);
  p.bending_stiffness = 40.0;
  RigidBody crumb;  // the far end is free
  crumb.mass = 1e-6;
  crumb.inertia = Vector3::Constant(1e-6);
  const CableModel model = CableModel(p, 8, air()).withBodies({std::nullopt, crumb});
  SteadyEnds ends;
  ends.clamps.vessel = Vector3::UnitX();
  NodeField shape(9);
  for (int i = 0; i <= 8; ++i)
    shape[i] << 0.25 * i, 0.0, 0.0, 1.0, 0.0, 0.0;
  SteadyStateSolver solver(model.nodes());
  ASSERT_TRUE(solver.solveFrom(model, ends, shape).converged());
  const double w = 0.05 * 9.81;
  EXPECT_NEAR(shape.back().z(), -w * 16.0 / (8.0 * 40.0), 2e-3 * w * 16.0 / 320.0);
  CableState state(0.0, shape, Vector3::Zero());
  state.clamps.vessel = ends.clamps.vessel;
  const EndForces forces = endForces(model, state);
  EXPECT_NEAR(forces.vessel.z(), -w * 2.0, 1e-4);
  EXPECT_NEAR(forces.vessel_moment.y(), w * 2.0, 2e-3 * w) << "its weight turns the clamp down, about +y";
  EXPECT_NEAR(forces.vessel_moment.x(), 0.0, 1e-9);
}

// Clamped at both ends and held there: 4 pi^2 EI / L^2 of the load of a strut does not matter; the sag is
// w L^4 / 384 EI, a fifth of that of a hinged beam, and the moments at the ends w L^2 / 12.
TEST(ClampedEnd, ABeamBetweenTwoClamps)
{
  CableProperties p = plainCable(2.0, 0.02, 0.05, 1e4);
  p.bending_stiffness = 40.0;
  const CableModel model(p, 10, air());
  SteadyEnds ends;
  ends.vehicle = {2.0, 0.0, 0.0};
  ends.clamps.vessel = ends.clamps.vehicle = Vector3::UnitX();
  const NodeField shape = steadyShape(model, ends);
  const double w = 0.05 * 9.81;
  EXPECT_NEAR(shape[5].z(), -w * 16.0 / (384.0 * 40.0), 5e-3 * w * 16.0 / (384.0 * 40.0));
  CableState state(0.0, shape, Vector3::Zero());
  state.clamps.vessel = state.clamps.vehicle = Vector3::UnitX();
  const EndForces forces = endForces(model, state);
  EXPECT_NEAR(forces.vessel_moment.y(), w * 4.0 / 12.0, 5e-3 * w);
  EXPECT_NEAR(forces.vehicle_moment.y(), -w * 4.0 / 12.0, 5e-3 * w);
}

// In motion the tether follows the clamp's turn.
TEST(ClampedEnd, TheSlopeFollowsATurningClamp)
{
  CableProperties p = towCable();
  p.length = 10.0;
  p.bending_stiffness = 30.0;
  const CableModel model(p, 20, Environment());
  SteadyEnds ends;
  ends.vehicle = {8.0, 0.0, -3.0};
  ends.clamps.vessel = Vector3::UnitX();
  CableState state(0.0, steadyShape(model, ends), Vector3::Zero());
  BoundaryConditions held = heldAt(state);
  AdaptiveStepper stepper(model, StepperOptions());
  for (double t = 0.05; t < 5.0; t += 0.05)
  {
    const double angle = 0.4 * std::sin(t);
    held.clamps.vessel = {std::cos(angle), 0.0, std::sin(angle)};
    ASSERT_TRUE(stepper.advance(model, held, t, state).converged());
    const Vector3 along = state.q.front().tail<3>().normalized();
    EXPECT_GT(along.dot(held.clamps.vessel), std::cos(2e-3)) << t;
  }
}

}  // namespace tether_monitor::core
