// Tethers in waves against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
// Half the range of the sum of the vertical end forces over two periods, waves having come on at rest.
double verticalForceInWaves(const CableModel& model, const SteadyEnds& ends)
{
  CableState state(0.0, steadyShape(model, ends), Vector3::Zero());
  StepperOptions options;
  options.step = 0.05;
  AdaptiveStepper stepper(model, options);
  const BoundaryConditions rest = heldAt(state);
  double low = INFINITY, high = -INFINITY;
  for (double t = 0.05; t < 60.0; t += 0.05)
  {
    EXPECT_TRUE(stepper.advance(model, rest, t, state).converged());
    const EndForces f = endForces(model, state);
    if (t < 40.0)
      continue;
    low = std::min(low, f.vessel.z() + f.vehicle.z());
    high = std::max(high, f.vessel.z() + f.vehicle.z());
  }
  return 0.5 * (high - low);
}
}  // namespace

// The pressure of the wave pushes a vertical tether along itself: Froude and Krylov's force is rho A a_w, and
// nothing moves. Integral of rho A a w^2 exp(k z) between the ends.
TEST(Waves, PressurePushesAVerticalTetherAlongItself)
{
  const CableProperties p = plainCable(39.97, 0.15, 40.0, 1e8);
  Environment sea;
  sea.waves.components = {{1.5, 120.0, 0.4, 0.0}};
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -12.0};
  ends.vehicle = {0.0, 0.0, -52.0};
  const double k = 2.0 * M_PI / 120.0, w2 = 9.81 * k;
  const double expected =
      1025.0 * M_PI / 4.0 * 0.15 * 0.15 * 1.5 * w2 * (std::exp(-12.0 * k) - std::exp(-52.0 * k)) / k;
  for (const int elements : {8, 40})
  {
    sea.waves.stretching = WaveStretching::NONE;
    EXPECT_NEAR(verticalForceInWaves(CableModel(p, elements, sea), ends), expected, 2e-3 * expected);
    sea.waves.stretching = WaveStretching::WHEELER;
    EXPECT_NEAR(verticalForceInWaves(CableModel(p, elements, sea), ends), expected, 1e-2 * expected);
  }
}

// A tether of water: wherever it is free, it goes with the water, along itself as well as across.
TEST(Waves, ANeutralFreeTetherGoesWithTheWater)
{
  CableProperties p = plainCable(3.0, 0.1, 1025.0 * M_PI / 4.0 * 0.1 * 0.1, 1e6);
  p.added_mass_tangential = 0.3;
  RigidBody drop;
  drop.mass = 1e-3;
  drop.volume = drop.mass / 1025.0;
  drop.inertia = Vector3::Constant(1e-3);
  Environment sea;
  sea.waves.components = {{0.2, 400.0, 0.0, 0.5}};  // low: nothing of the second order
  sea.waves.stretching = WaveStretching::NONE;
  for (const Vector3& along : {Vector3(Vector3::UnitX()), Vector3(-Vector3::UnitZ())})
  {
    const CableModel model = CableModel(p, 4, sea).withBodies({drop, drop});
    NodeField shape(5);
    for (int i = 0; i < 5; ++i)
      shape[i] << Vector3(0.0, 0.0, -20.0) + 0.75 * i * along, along;
    const Vector3 middle = shape[2].head<3>();
    const WaveField& waves = model.environment().waves();
    CableState state(0.0, shape, waves.at(middle, 0.0).velocity);
    AdaptiveStepper stepper(model, StepperOptions{});
    double worst = 0.0, swing = 0.0;
    for (double t = 0.1; t < 16.0; t += 0.1)
    {
      ASSERT_TRUE(stepper.advance(model, BoundaryConditions(), t, state).converged());
      const Vector3 water = waves.at(state.q[2].head<3>(), t).velocity;
      worst = std::max(worst, std::abs(along.dot(Vector3(state.v[2].head<3>() - water))));
      swing = std::max(swing, std::abs(along.dot(water)));
    }
    EXPECT_GT(swing, 0.05);
    EXPECT_LT(worst, 0.02 * swing) << along.transpose();
  }
}

// A stiff, short, taut tether stands across the waves: both ends together carry Morison's force, inertia and drag.
TEST(Waves, MorisonForceOnATautTether)
{
  Environment sea;
  sea.waves.components = {{1.0, 60.0, 0.0, 0.0}};
  CableProperties p = towCable();
  p.length = 4.0;
  p.diameter = 0.2;
  p.mass_per_length = 40.0;
  p.drag_normal = 1.1;
  p.added_mass_normal = 1.0;
  CableModel model(p, 8, sea);
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -6.0};
  ends.vehicle = {0.0, 0.0, -10.01};
  CableState state(0.0, steadyShape(model, ends), Vector3::Zero());
  StepperOptions options;
  options.step = 0.02;
  AdaptiveStepper stepper(model, options);
  const BoundaryConditions rest = heldAt(state);
  const double area = M_PI / 4.0 * 0.04;
  double worst = 0.0, size = 0.0;
  for (double t = 20.0; t < 28.0; t += 0.1)  // its own swing has died away
  {
    ASSERT_TRUE(stepper.advance(model, rest, t, state).converged());
    double expected = 0.0;
    for (int i = 0; i < 400; ++i)
    {
      const double z = -6.0 - 4.01 * (i + 0.5) / 400;
      const WaveMotion water = model.environment().waves().at(Vector3(0.0, 0.0, z), t);
      expected += 0.01 * (1025.0 * area * 2.0 * water.acceleration.x() +
                          0.5 * 1025.0 * 0.2 * 1.1 * std::abs(water.velocity.x()) * water.velocity.x());
    }
    const EndForces f = endForces(model, state);
    worst = std::max(worst, std::abs(f.vessel.x() + f.vehicle.x() - expected));
    size = std::max(size, std::abs(expected));
  }
  EXPECT_LT(worst, 0.02 * size);
}

}  // namespace tether_monitor::core
