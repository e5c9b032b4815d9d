// A tether that varies is the one that is built with other properties.
#include "tether_monitor/core/cable/property_variation.h"

#include <gtest/gtest.h>

#include "support/tethers.h"
#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"

namespace tether_monitor::core
{
namespace
{
RigidBody vehicle()
{
  RigidBody body;
  body.mass = 400.0;
  body.volume = 0.35;
  body.inertia = {40.0, 60.0, 60.0};
  body.drag_area = {0.6, 0.8, 0.8};
  return body;
}

// End forces after ten seconds of heave and current, from a curve that is not steady.
EndForces forcesOf(const CableProperties& p, const Environment& sea, const RigidBody& body,
                   const PropertyVariation& variation)
{
  CableLayout layout;
  Attachment weight;
  weight.name = "weight";
  weight.s = 0.4 * p.length;
  weight.mass = 5.0;
  weight.volume = 1e-3;
  weight.drag_area = 0.1;
  layout.attachments.push_back(weight);
  const CableModel model = CableModel(p, 12, sea, layout).withBodies({std::nullopt, body});
  NodeField shape(model.nodes());
  for (int i = 0; i < model.nodes(); ++i)
    shape[i] << 0.6 * model.mesh().arcLength(i), 0.0, -2.0 - 0.8 * model.mesh().arcLength(i), 0.6, 0.0, -0.8;
  Deployment deployment;
  deployment.variation = variation;
  CableState state(0.0, shape, Vector3::Zero(), deployment);
  initializeContact(model, state);
  AdaptiveStepper stepper(model, StepperOptions());
  BoundaryConditions ends;
  ends.vessel = EndTrajectory::between(0.0, {{0, 0, -2}, {0.2, 0, 0}}, 10.0, {{1, 0.5, -1}, {0, 0, 0.1}});
  EXPECT_TRUE(stepper.advance(model, ends, 10.0, state).converged());
  return endForces(model, state);
}

void expectSame(const EndForces& a, const EndForces& b, const char* what)
{
  EXPECT_LT((a.vessel - b.vessel).norm(), 1e-3 * b.vessel.norm()) << what;
  EXPECT_LT((a.vehicle - b.vehicle).norm(), 1e-3 * b.vehicle.norm()) << what;
}
}  // namespace

TEST(PropertyVariation, IsATetherOfOtherProperties)
{
  const CableProperties built = towCable();
  Environment sea;
  sea.current = CurrentProfile(Vector3(0.4, 0.1, 0.0));
  const EndForces usual = forcesOf(built, sea, vehicle(), {});

  PropertyVariation v;
  CableProperties p = built;
  v.drag_normal = 1.4;
  v.drag_tangential = 0.7;
  v.mass_per_length = 1.05;
  v.axial_stiffness = 0.8;
  p.drag_normal *= v.drag_normal;
  p.drag_tangential *= v.drag_tangential;
  p.mass_per_length *= v.mass_per_length;
  p.axial_stiffness *= v.axial_stiffness;
  const EndForces varied = forcesOf(built, sea, vehicle(), v);
  expectSame(varied, forcesOf(p, sea, vehicle(), {}), "tether");
  EXPECT_GT((varied.vessel - usual.vessel).norm(), 0.01 * usual.vessel.norm()) << "it does something";

  v = {};
  v.length = 1.01;
  p = built;
  p.permanent_elongation = 0.01;
  expectSame(forcesOf(built, sea, vehicle(), v), forcesOf(p, sea, vehicle(), {}), "length");

  v = {};
  v.vehicle_drag = 1.5;
  RigidBody body = vehicle();
  body.drag_area *= 1.5;
  expectSame(forcesOf(built, sea, vehicle(), v), forcesOf(built, sea, body, {}), "drag of the vehicle");
}

TEST(PropertyVariation, ACurrentOnTopIsThatOfTheWater)
{
  const CableProperties p = towCable();
  const auto withCurrent = [&](const Vector3& surface, const Vector3& deep)
  {
    Environment sea;
    sea.current = CurrentProfile({{0.0, surface}, {200.0, deep}});
    return sea;
  };
  const Vector3 current(0.4, 0.1, 0.0), more(-0.1, 0.2, 0.0), sheared(0.3, 0.0, 0.0);
  PropertyVariation v;
  v.current = more;
  v.shear = sheared / 200.0;
  v.shear_depth = 200.0;
  const EndForces expected =
      forcesOf(p, withCurrent(current + more, current + more + sheared), vehicle(), PropertyVariation());
  expectSame(forcesOf(p, withCurrent(current, current), vehicle(), v), expected, "by the table of the water");
  Environment uniform;
  uniform.current = CurrentProfile(current);
  expectSame(forcesOf(p, uniform, vehicle(), v), expected, "by the kernels");
  EXPECT_EQ(v.currentAt(10.0), more) << "nothing grows above the water";
  EXPECT_LT((v.currentAt(-500.0) - more - sheared).norm(), 1e-12);
}

TEST(PropertyVariation, WhatNoTetherCanBeIsNotValid)
{
  PropertyVariation v;
  EXPECT_TRUE(v.isValid());
  v.mass_per_length = 0.0;
  EXPECT_FALSE(v.isValid());
  v = {};
  v.current.x() = NAN;
  EXPECT_FALSE(v.isValid());
}
}  // namespace tether_monitor::core
