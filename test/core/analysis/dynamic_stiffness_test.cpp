#include "tether_monitor/core/analysis/dynamic_stiffness.h"

#include <gtest/gtest.h>

#include "tether_monitor/core/assembly/contact_assembly.h"
#include "tether_monitor/core/assembly/station_profile.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::core
{
namespace
{
CableProperties properties()
{
  CableProperties p;
  p.length = 100.0;
  p.diameter = 0.01;
  p.mass_per_length = 0.5;
  p.axial_stiffness = 1e6;
  p.drag_normal = 1.2;
  p.drag_tangential = 0.03;
  p.working_load = 1e4;
  p.breaking_load = 2e4;
  return p;
}

RigidBody weight()
{
  RigidBody body;
  body.mass = 300.0;
  body.volume = 0.1;
  body.inertia = Vector3::Constant(20.0);
  body.drag_area = Vector3::Constant(0.5);
  body.added_mass = Vector3::Constant(80.0);
  return body;
}

struct Hanging
{
  Hanging(int elements, const Vector3& velocity) : model(properties(), elements, Environment())
  {
    model = model.withBodies({std::nullopt, weight()});
    start = {{0, 0, -2}, {0, 0, -100}, velocity};
    NodeField shape;
    SteadyStateSolver statics(model.nodes());
    EXPECT_TRUE(statics.solve(model, start, shape).converged());
    state = CableState(0.0, shape, velocity);
    initializeContact(model, state);
  }
  EndDynamicStiffness at(double sigma)
  {
    EndDynamicStiffness z;
    EXPECT_TRUE(EndDynamicStiffnessSolver(model.nodes()).solve(model, state, sigma, z));
    return z;
  }

  CableModel model;
  SteadyEnds start;
  CableState state;
};
}  // namespace

TEST(EndDynamicStiffness, OfAHangingWeightIsThatOfAPendulumAndABar)
{
  Hanging hanging(20, Vector3::Zero());
  const EndDynamicStiffness z = hanging.at(1e-4);
  const EndForces forces = endForces(hanging.model, hanging.state);
  // A pendulum in a heavy line: the tension at the lower end over the distance that the line's weight makes a
  // little longer; between the two tensions.
  EXPECT_GT(z.vehicle(0, 0), forces.vehicle.norm() / 100.0);
  EXPECT_LT(z.vehicle(0, 0), forces.vessel.norm() / 100.0);
  EXPECT_NEAR(z.vehicle(2, 2), 1e6 / 100.0, 1e6 / 100.0 * 0.01);
  // SteadyStateSolver: what moves with the vehicle pulls at the vessel.
  EXPECT_NEAR(z.transfer(2, 2), -z.vehicle(2, 2), 1e-3 * z.vehicle(2, 2));
  // A vessel that moves takes everything along.
  EXPECT_NEAR(z.vessel.norm(), 0.0, 1e-2);
}

TEST(EndDynamicStiffness, FastMotionFeelsTheInertiaOfTheVehicle)
{
  Hanging hanging(20, Vector3::Zero());
  const double sigma = 0.5;
  const EndDynamicStiffness z = hanging.at(sigma);
  const RigidBody body = weight();
  const double inertia = sigma * sigma * (body.mass + body.added_mass.x());
  EXPECT_NEAR((z.vehicle - z.tether)(0, 0), inertia, 1e-6 * inertia);
  EXPECT_GT(z.vessel(2, 2), inertia) << "with the tether's own mass";
}

TEST(EndDynamicStiffness, IsTheTransformOfTheStepResponseOfATow)
{
  // The exact answer of the equations of motion to a small force, transformed: integral of sigma e^(-sigma t)
  // x(t).
  Hanging tow(12, {2.0, 0.0, 0.0});
  const double force = 5.0, h = 0.02;
  for (const double sigma : {0.05, 0.2})
    for (const int axis : {0, 1, 2})
    {
      CableState still = tow.state, pushed = tow.state;
      StepperOptions options;
      options.step = h;
      options.newton.relative_tolerance = 1e-10;
      AdaptiveStepper stepper(tow.model, options);
      Vector3 transform = Vector3::Zero();
      const int steps = static_cast<int>(9.0 / sigma / h);
      for (int i = 1; i <= steps; ++i)
      {
        BoundaryConditions ends;
        ends.vessel = EndTrajectory::uniform(0.0, {tow.start.vessel, tow.start.velocity});
        ASSERT_TRUE(stepper.advance(tow.model, ends, i * h, still).converged());
        ends.vehicle_force[axis] = force;
        ASSERT_TRUE(stepper.advance(tow.model, ends, i * h, pushed).converged());
        transform += h * sigma * std::exp(-sigma * (i - 0.5) * h) * (pushed.q.back() - still.q.back()).head<3>();
      }
      const Vector3 expected = tow.at(sigma).vehicle.inverse().col(axis) * force;
      EXPECT_LT((transform - expected).norm(), 0.02 * expected.norm()) << sigma << " " << axis;
    }
}
}  // namespace tether_monitor::core
