// A hanging tether with a body at its end parts: what falls falls with g, what is left hangs by its own weight.
#include <gtest/gtest.h>

#include "support/tethers.h"
#include "tether_monitor/core/analysis/vortex_shedding.h"
#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LENGTH = 100.0, PARTS_AT = 60.0, WEIGHT = 0.5 * 9.81;  // [m, m, N/m]

struct Hanging
{
  explicit Hanging(double axial_damping = 1e-3)
  {
    CableLayout layout;
    layout.attachments = {{"parting", PARTS_AT, 0.0, 0.0, 0.0}};
    RigidBody body;
    body.mass = 200.0;
    body.inertia = Vector3::Constant(20.0);
    CableProperties tether = plainCable(LENGTH, 0.02, 0.5, 1e6);
    tether.axial_damping = axial_damping;
    model = CableModel(tether, 20, air(), layout).withBodies({std::nullopt, body});
    SteadyStateSolver statics(model.nodes());
    SteadyEnds ends;
    NodeField shape;
    EXPECT_TRUE(statics.solve(model, ends, shape).converged());
    state = CableState(0.0, shape, Vector3::Zero());
    parted = model.mesh().nearestNode(PARTS_AT);
    state.deployment.parted_element = parted;
  }
  bool fall(double t, Scheme scheme = Scheme::GENERALIZED_ALPHA)
  {
    StepperOptions options;
    options.scheme = scheme;
    AdaptiveStepper stepper(model, options);
    BoundaryConditions paths;
    paths.vessel = EndTrajectory::uniform(0.0, {});
    stepper.expectShock(state);
    return stepper.advance(model, paths, t, state).converged();
  }
  // Height of the centre of mass of body and lower piece.
  double lowerCenter() const
  {
    double mass = model.bodies().vehicle->mass, moment = mass * state.q.back().z();
    const DeployedCable cable(model, state.deployment);
    for (int i = 0; i < cable.elements(); ++i)
      if (i > parted)
      {
        const ShapeMatrix M = massMatrix(cable.element(i).length) * cable.element(i).mass;
        mass += cable.element(i).mass * cable.element(i).length;
        for (int k : {0, 2})
          for (int j = 0; j < 4; ++j)
            moment += M(k, j) * (j < 2 ? state.q[i] : state.q[i + 1])[3 * (j % 2) + 2];
      }
    return moment / mass;
  }
  CableModel model{plainCable(LENGTH, 0.02, 0.5, 1e6), 20, air()};
  CableState state;
  int parted = 0;
};
}  // namespace

TEST(PartedTether, WhatIsBelowFallsFreely)
{
  Hanging tether;
  const double before = tether.lowerCenter(), t = 2.0;
  ASSERT_TRUE(tether.fall(t));
  EXPECT_NEAR(before - tether.lowerCenter(), 0.5 * 9.81 * t * t, 1e-3 * 0.5 * 9.81 * t * t);
}

TEST(PartedTether, WhatIsLeftHangsByItsOwnWeight)
{
  Hanging tether;
  ASSERT_TRUE(tether.fall(60.0));
  const DeployedCable cable(tether.model, tether.state.deployment);
  const double left = PARTS_AT * WEIGHT;
  EXPECT_NEAR(endForces(cable, tether.state).vessel.norm(), left, 0.02 * left);
  StationProfile profile(tether.model.elements());
  computeStations(cable, tether.state, profile);
  EXPECT_EQ(profile.tension[2 * tether.parted + 1], 0.0);
  EXPECT_EQ(profile.strain[2 * tether.parted + 1], 0.0);
  EXPECT_NEAR(profile.stretched_length, LENGTH - cable.element(tether.parted).length, 0.05);
  EXPECT_LT(std::abs(profile.tension[2 * tether.parted]), 0.05 * left);
}

TEST(PartedTether, TheExplicitSchemeFallsToo)
{
  Hanging tether(0.0);
  const double before = tether.lowerCenter();
  ASSERT_TRUE(tether.fall(0.5, Scheme::ABARBANEL_ZWAS));
  EXPECT_NEAR(before - tether.lowerCenter(), 0.5 * 9.81 * 0.25, 0.01 * 0.5 * 9.81 * 0.25);
  std::vector<double> factor;
  const DeployedCable cable(tether.model, tether.state.deployment);
  EXPECT_TRUE(std::isfinite(findLockIn(cable, tether.state, 1.5, factor).fundamental_frequency));
}

}  // namespace tether_monitor::core
