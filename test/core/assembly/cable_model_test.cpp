#include "tether_monitor/core/assembly/cable_model.h"

#include <gtest/gtest.h>

#include <functional>

#include "support/tethers.h"

namespace tether_monitor::core
{
// One row for each documented bound: what violates it, and the name that the message must contain.
struct Violation
{
  const char* name;
  std::function<void(CableProperties&, Environment&, int&)> make;
};

class ModelRefuses : public ::testing::TestWithParam<Violation>
{
};

TEST_P(ModelRefuses, AndNamesTheArgument)
{
  CableProperties p = towCable();
  Environment sea;
  int elements = 10;
  ASSERT_NO_THROW(CableModel(p, elements, sea)) << "precondition";
  GetParam().make(p, sea, elements);
  try
  {
    CableModel(p, elements, sea);
    FAIL() << "accepted";
  }
  catch (const std::invalid_argument& error)
  {
    EXPECT_NE(std::string(error.what()).find(GetParam().name), std::string::npos) << error.what();
  }
}

using P = CableProperties;
using E = Environment;
INSTANTIATE_TEST_SUITE_P(
    Bounds, ModelRefuses,
    ::testing::Values(Violation{"tether.length", [](P& p, E&, int&) { p.length = 0.0; }},
                      Violation{"tether.length", [](P& p, E&, int&) { p.length = NAN; }},
                      Violation{"tether.diameter", [](P& p, E&, int&) { p.diameter = -0.01; }},
                      Violation{"tether.mass_per_length", [](P& p, E&, int&) { p.mass_per_length = 0.0; }},
                      Violation{"tether.axial_stiffness", [](P& p, E&, int&) { p.axial_stiffness = INFINITY; }},
                      Violation{"tether.bending_stiffness", [](P& p, E&, int&) { p.bending_stiffness = -1.0; }},
                      Violation{"tether.axial_damping", [](P& p, E&, int&) { p.axial_damping = -1.0; }},
                      Violation{"tether.drag_normal", [](P& p, E&, int&) { p.drag_normal = -1.0; }},
                      Violation{"tether.drag_tangential", [](P& p, E&, int&) { p.drag_tangential = NAN; }},
                      Violation{"tether.added_mass_normal", [](P& p, E&, int&) { p.added_mass_normal = -0.1; }},
                      Violation{"tether.working_load", [](P& p, E&, int&) { p.working_load = 7.0e4; }},
                      Violation{"tether.breaking_load", [](P& p, E&, int&) { p.breaking_load = 0.0; }},
                      Violation{"tether.load_area", [](P& p, E&, int&) { p.load_area = 0.0; }},
                      Violation{"tether.min_bend_radius", [](P& p, E&, int&) { p.min_bend_radius = -1.0; }},
                      Violation{"tether.elements", [](P&, E&, int& n) { n = 0; }},
                      Violation{"environment.water_density", [](P&, E& e, int&) { e.water_density = -1.0; }},
                      Violation{"environment.gravity", [](P&, E& e, int&) { e.gravity = NAN; }}));

TEST(StepperRefuses, BadOptions)
{
  const CableModel model(towCable(), 2, Environment());
  EXPECT_THROW(AdaptiveStepper(model, {0.0, 0.6, 10, 400, {}}), std::invalid_argument);
  EXPECT_THROW(AdaptiveStepper(model, {0.05, 1.1, 10, 400, {}}), std::invalid_argument);
  EXPECT_THROW(AdaptiveStepper(model, {0.05, 0.6, -1, 400, {}}), std::invalid_argument);
  EXPECT_THROW(AdaptiveStepper(model, {0.05, 0.6, 10, 0, {}}), std::invalid_argument);
}

TEST(CableModel, ServesStatesOfDifferentDeploymentsInTurn)
{
  const CableModel model(towCable(), 6, Environment());
  const auto stateOf = [](double length, double rate)
  {
    NodeField shape(7);
    for (int i = 0; i <= 6; ++i)
      shape[i] << 0.9 * length * i / 6.0, 0.1 * i * i, -50.0 - 0.4 * length * i / 6.0, 0.9, 0.01 * i, -0.4;
    Deployment deployment;
    deployment.payout = PayoutState{length, rate, 0.0};
    return CableState(0.0, shape, Vector3(1.0, 0.5, 0.0), deployment);
  };
  const CableState states[] = {stateOf(400.0, 0.0), stateOf(450.0, 1.0)};
  NodeField alone[2] = {NodeField(7), NodeField(7)};
  for (int k = 0; k < 2; ++k)
    DeployedCable(model, states[k].deployment).assemble(states[k], alone[k]);
  ASSERT_GT((alone[0][3] - alone[1][3]).norm(), 1.0) << "precondition: they differ";
  DeployedCable shared(model);
  NodeField residual(7);
  for (int round = 0; round < 3; ++round)
    for (int k = 0; k < 2; ++k)
    {
      shared.update(model, states[k].deployment);
      shared.assemble(states[k], residual);
      for (int i = 0; i < 7; ++i)
        EXPECT_EQ(residual[i], alone[k][i]) << "state " << k << ", node " << i << ", round " << round;
    }
}

TEST(CableModel, AChangedModelSharesTheTetherAndLeavesTheOldOneAlone)
{
  const CableModel model(towCable(), 4, Environment());
  const CableModel in_air = model.withEnvironment(EnvironmentModel(air()));
  EXPECT_EQ(in_air.environment().density(), 0.0);
  EXPECT_EQ(model.environment().density(), 1025.0);
  EXPECT_TRUE(in_air.sharesTether(model));
  EXPECT_FALSE(in_air.isSame(model));
  EndBodies bodies;
  bodies.vehicle.emplace();
  bodies.vehicle->mass = 3.0;
  bodies.vehicle->inertia = Vector3::Ones();
  const CableModel with_body = model.withBodies(bodies);
  EXPECT_EQ(with_body.bodies().vehicle->mass, 3.0);
  EXPECT_FALSE(model.bodies().vehicle);
  EXPECT_TRUE(with_body.sharesTether(model));
  EXPECT_TRUE(CableModel(model).isSame(model));
  EXPECT_FALSE(CableModel(towCable(), 4, Environment()).sharesTether(model)) << "another call";
  bodies.vehicle->mass = -1.0;
  EXPECT_THROW(model.withBodies(bodies), std::invalid_argument);
}

}  // namespace tether_monitor::core
