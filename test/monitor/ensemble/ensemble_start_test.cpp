#include "tether_monitor/monitor/ensemble/ensemble_start.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/navigation_fixture.h"

namespace tether_monitor::monitor
{
namespace
{
using core::Matrix3;

struct Tow
{
  Tow() : config(observedConfig()), model(config.tether, 10, config.environment), statics(model.nodes())
  {
    model = model.withBodies({std::nullopt, config.vehicle_body});
    inputs.ends.vessel = {0.0, 0.0, -1.0};
    inputs.ends.velocity = {2.0, 0.0, 0.0};
    inputs.position_covariance = 0.04 * Matrix3::Identity();
    inputs.velocity_stddev.setZero();
    inputs.thrust.setZero();
    inputs.force.slow_stddev = 30.0;
    inputs.force.fast_stddev = 10.0;
    inputs.ends.vehicle = {0.0, 0.0, -80.0};
  }
  // Where a vehicle is towed on a tether that differs, and its shape.
  core::NodeField shapeOf(const core::PropertyVariation& variation)
  {
    core::SteadyEnds ends = inputs.ends;
    ends.deployment.variation = variation;
    core::NodeField shape;
    EXPECT_TRUE(statics.solve(model, ends, shape).converged());
    return shape;
  }
  EnsembleStart find(const core::NodeField& near)
  {
    EnsembleStart start;
    EXPECT_TRUE(findEnsembleStart(parameterPrior(config), 64, statics, model, inputs, near, start));
    return start;
  }

  Config config;
  core::CableModel model;
  core::SteadyStateSolver statics;
  EnsembleStartInputs inputs{};
};

double meanOf(const EnsembleStart& start, Parameter p)
{
  double sum = 0.0;
  for (const MemberStart& member : start.members)
    sum += member.parameters[p] / static_cast<double>(start.members.size());
  return sum;
}
}  // namespace

TEST(EnsembleStart, LearnsFromWhereTheVehicleIs)
{
  Tow tow;
  tow.config.uncertainty.current = 0.01;
  const core::NodeField usual = tow.shapeOf({});
  core::PropertyVariation light;
  light.drag_normal = 1.35;
  tow.inputs.ends.vehicle = tow.shapeOf(light).back().head<3>();
  ASSERT_GT((tow.inputs.ends.vehicle - usual.back().head<3>()).norm(), 1.0) << "precondition";
  const EnsembleStart start = tow.find(usual);
  EXPECT_GT(meanOf(start, DRAG_NORMAL), 0.05) << "towards ln 1.35 = 0.30, as far as nothing else explains it";
  for (const MemberStart& member : start.members)
  {
    EXPECT_LT((member.shape.back().head<3>() - tow.inputs.ends.vehicle).norm(), 1.5);
    EXPECT_LT(member.force.norm(), 150.0);
  }
}

TEST(EnsembleStart, APlaceThatNobodyKnowsTellsNothing)
{
  Tow tow;
  const core::NodeField usual = tow.shapeOf({});
  tow.inputs.ends.vehicle = usual.back().head<3>() + Vector3(0.0, 5.0, 2.0);
  tow.inputs.position_covariance = 1e6 * Matrix3::Identity();
  const EnsembleStart start = tow.find(usual);
  const ParameterPrior prior = parameterPrior(tow.config);
  for (int k = 0; k < PARAMETERS; ++k)
    EXPECT_LT(std::abs(meanOf(start, static_cast<Parameter>(k))), 0.2 * prior.stddev[k] + 1e-12) << k;
}

TEST(EnsembleStart, ALengthThatIsWrongIsFoundInATautTow)
{
  Tow tow;
  const core::NodeField usual = tow.shapeOf({});
  core::PropertyVariation longer;
  longer.length = 1.012;
  tow.inputs.ends.vehicle = tow.shapeOf(longer).back().head<3>();
  const EnsembleStart start = tow.find(usual);
  EXPECT_NEAR(meanOf(start, LENGTH), 0.012, 0.005);
}
}  // namespace tether_monitor::monitor
