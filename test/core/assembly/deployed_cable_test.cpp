#include "tether_monitor/core/assembly/deployed_cable.h"

#include <gtest/gtest.h>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
CableModel weighted()
{
  CableLayout layout;
  CableProperties heavy = towCable();
  heavy.mass_per_length = 5.0;
  layout.sections = {{300.0, 400.0, heavy}};
  layout.attachments = {{"float", 250.0, 7.0, 0.02, 0.0}};
  return CableModel(towCable(), 16, Environment(), layout);
}

Deployment paidOut(double length)
{
  Deployment deployment;
  deployment.payout = PayoutState{length, 0.5, 0.0};
  return deployment;
}
}  // namespace

TEST(DeployedCable, ArcLengthIsTheSumOfTheElements)
{
  const CableModel model = weighted();
  for (const Deployment& deployment : {Deployment(), paidOut(430.0), paidOut(360.0)})
  {
    const DeployedCable cable(model, deployment);
    double sum = 0.0;
    EXPECT_EQ(cable.arcLength(0), 0.0);
    for (int i = 0; i < cable.elements(); ++i)
    {
      sum += cable.element(i).length;
      EXPECT_NEAR(cable.arcLength(i + 1), sum, 1e-10);
    }
    EXPECT_NEAR(cable.length(), model.length(deployment), 1e-10);
  }
}

TEST(DeployedCable, MassIsThatOfEverySectionAndWhatIsFixedToIt)
{
  EXPECT_NEAR(DeployedCable(weighted()).mass(), 300.0 * 1.43 + 100.0 * 5.0 + 7.0, 1e-9);
  EXPECT_NEAR(DeployedCable(weighted(), paidOut(430.0)).mass(), 330.0 * 1.43 + 100.0 * 5.0 + 7.0, 1e-9);
}

TEST(DeployedCable, UpdatingToAnotherLengthAndBackIsAsIfMadeThere)
{
  const CableModel model = weighted();
  const DeployedCable fresh(model, paidOut(430.0));
  DeployedCable cable(model, paidOut(360.0));
  ASSERT_NE(cable.element(0).length, fresh.element(0).length) << "precondition";
  for (int round = 0; round < 2; ++round)
  {
    cable.update(model, paidOut(430.0));  // the second time nothing is new
    EXPECT_EQ(cable.mass(), fresh.mass());
    EXPECT_EQ(cable.largestStiffness(), fresh.largestStiffness());
    for (int i = 0; i < cable.elements(); ++i)
    {
      EXPECT_EQ(cable.element(i).length, fresh.element(i).length);
      EXPECT_EQ(cable.element(i).bending_stiffness, fresh.element(i).bending_stiffness);
      EXPECT_EQ(cable.element(i).transport.speed_a, fresh.element(i).transport.speed_a);
      EXPECT_EQ(cable.arcLength(i + 1), fresh.arcLength(i + 1));
    }
  }
}

TEST(DeployedCable, StiffeningLastsUntilTheNextUpdate)
{
  const CableModel model(towCable(), 4, Environment());
  DeployedCable cable(model);
  const double before = cable.element(0).bending_stiffness;
  cable.stiffen(2.0);
  EXPECT_NEAR(cable.element(0).bending_stiffness, 2.0 * 1.43 * 9.80665 * 1e6, 0.01 * 2.0 * 1.43 * 9.8e6);
  cable.update(model, Deployment());
  EXPECT_EQ(cable.element(0).bending_stiffness, before);
}

TEST(DeployedCable, DragFactorsActOnTheirElementAlone)
{
  const CableModel model(towCable(), 3, Environment());
  Deployment deployment;
  deployment.drag_factor = {1.0, 2.5, 1.0};
  const DeployedCable cable(model, deployment);
  EXPECT_EQ(cable.element(0).drag_normal, 1.35);
  EXPECT_DOUBLE_EQ(cable.element(1).drag_normal, 2.5 * 1.35);
  EXPECT_EQ(cable.element(2).drag_normal, 1.35);
  EXPECT_EQ(cable.element(1).drag_tangential, 0.12566);
}
}  // namespace tether_monitor::core
