#include "tether_monitor/monitor/model/model_factory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/estimator_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
Config withFloat(double s)
{
  Config c = testConfig();
  c.layout.attachments = {{"float", s, 1.0, 0.01, 0.0}};
  return c;
}
}  // namespace

TEST(ModelFactory, AVehicleIsInTheModelUnlessItIsTracked)
{
  Config c = testConfig();
  c.vehicle_body = smallVehicle();
  c.vehicle.attachment = {0.5, 0.0, 0.2};
  EXPECT_FALSE(makeModel(c).bodies().vehicle);
  c.vehicle_mode = VehicleMode::FREE;
  const core::CableModel model = makeModel(c);
  ASSERT_TRUE(model.bodies().vehicle);
  EXPECT_EQ(model.bodies().vehicle->mass, 150.0);
  EXPECT_EQ(model.bodies().vehicle->attachment, core::Vector3(0.5, 0.0, 0.2));
  EXPECT_FALSE(model.bodies().vessel);
}

TEST(ModelFactory, WhatIsFixedKeepsItsDistanceFromTheVehicle)
{
  const core::CableModel model = makeModel(withFloat(40.0), 130.0, 25);
  EXPECT_EQ(model.length(), 130.0);
  EXPECT_EQ(model.elements(), 25);
  ASSERT_EQ(model.lumpedAttachments().size(), 1u);
  EXPECT_NEAR(model.mesh().arcLength(model.lumpedAttachments()[0].node), 70.0, 1e-9);
  EXPECT_TRUE(makeModel(withFloat(40.0), 55.0, 20).lumpedAttachments().empty()) << "it has come aboard";
}

TEST(ModelFactory, NoMeshHasNoLengthOrTooFewElements)
{
  for (const double length : {0.0, -1.0, static_cast<double>(NAN), static_cast<double>(INFINITY)})
    EXPECT_FALSE(canMesh(testConfig(), length, 20)) << length;
  EXPECT_TRUE(canMesh(testConfig(), 100.0, 1));
  EXPECT_FALSE(canMesh(testConfig(), 100.0, 0));
  EXPECT_FALSE(canMesh(withFloat(40.0), 100.0, 1)) << "two pieces";
  EXPECT_TRUE(canMesh(withFloat(40.0), 100.0, 2));
  EXPECT_TRUE(canMesh(withFloat(40.0), 55.0, 1)) << "one is left";
  EXPECT_THROW(makeModel(withFloat(40.0), 100.0, 1), std::invalid_argument);
}

TEST(ModelFactory, AStateMustFitItsModel)
{
  const core::CableModel model(makeModel(testConfig()));
  core::NodeField shape(21, core::NodeCoords::Zero());
  core::CableState state(0.0, shape, core::Vector3::Zero());
  ASSERT_TRUE(isStateOf(state, model)) << "precondition";
  core::CableState changed = state;
  changed.q.pop_back();
  EXPECT_FALSE(isStateOf(changed, model));
  changed = state;
  changed.v[3][2] = NAN;
  EXPECT_FALSE(isStateOf(changed, model));
  changed = state;
  changed.deployment.drag_factor.assign(19, 1.0);
  EXPECT_FALSE(isStateOf(changed, model));
  changed.deployment.drag_factor.assign(20, 1.0);
  EXPECT_TRUE(isStateOf(changed, model));
  changed.deployment.payout = core::PayoutState{-1.0, 0.0, 0.0};
  EXPECT_FALSE(isStateOf(changed, model));
  changed = state;
  changed.obstacles.resize(1);
  EXPECT_FALSE(isStateOf(changed, model));
}
}  // namespace tether_monitor::monitor
