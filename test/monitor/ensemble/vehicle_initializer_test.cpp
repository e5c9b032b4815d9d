#include "tether_monitor/monitor/ensemble/vehicle_initializer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/navigation_fixture.h"
#include "tether_monitor/core/solve/dynamic_relaxation.h"

namespace tether_monitor::monitor
{
namespace
{
using core::Matrix3;

// A towed vehicle on which a force acts, and where it is then.
struct Tow
{
  Tow()
    : config(observedConfig()), model(config.tether, config.elements, config.environment), statics(model.nodes())
  {
    config.vehicle_body.mass = 600.0;
    model = model.withBodies({std::nullopt, config.vehicle_body});
    ends.vessel = {0.0, 0.0, -1.0};
    ends.velocity = {2.0, 0.0, 0.0};
  }

  // @return the place of a vehicle on which `force` acts.
  Vector3 placeUnder(const Vector3& force)
  {
    core::RigidBody body = config.vehicle_body;
    body.force += force;
    const core::CableModel loaded = model.withBodies({std::nullopt, body});
    core::NodeField shape;
    core::SteadyEnds at = ends;
    at.vehicle = {0.0, 0.0, -50.0};
    EXPECT_TRUE(statics.solve(loaded, at, shape).converged());
    return shape.back().head<3>();
  }

  // The likeliest start with a measured place that is known to `place_stddev` [m].
  core::SolveReport find(const core::SteadyEnds& at, double place_stddev, const Vector3& thrust,
                         const Vector3& force_stddev, VehicleInitialization& start)
  {
    const Matrix3 covariance = place_stddev * place_stddev * Matrix3::Identity();
    return findVehicleInitialization(statics, model, {at, covariance, thrust, force_stddev}, start);
  }

  Config config;
  core::CableModel model;
  core::SteadyStateSolver statics;
  core::SteadyEnds ends;
};
}  // namespace

TEST(VehicleInitialization, FindsTheForceThatKeepsTheVehicleWhereItIs)
{
  Tow tow;
  const Vector3 force(60.0, -80.0, 10.0), usual(200.0, 200.0, 200.0);
  tow.ends.vehicle = tow.placeUnder(force);
  VehicleInitialization start;
  ASSERT_TRUE(tow.find(tow.ends, 0.01, Vector3::Zero(), usual, start).converged());
  EXPECT_LT((start.force - force).norm(), 0.05 * force.norm()) << start.force.transpose();
  EXPECT_LT((start.shape.back().head<3>() - tow.ends.vehicle).norm(), 0.05);
  EXPECT_LT(start.cost, 3.0);
  // A place that nobody knows is left to the vehicle.
  tow.ends.vehicle += Vector3(0.0, 5.0, 0.0);
  ASSERT_TRUE(tow.find(tow.ends, 100.0, Vector3::Zero(), usual, start).converged());
  EXPECT_LT(start.force.norm(), 30.0);
}

TEST(VehicleInitialization, AThrustThatIsToldIsNoDisturbance)
{
  Tow tow;
  const Vector3 thrust(50.0, 70.0, 0.0), usual(200.0, 200.0, 200.0);
  tow.ends.vehicle = tow.placeUnder(thrust);
  VehicleInitialization start;
  ASSERT_TRUE(tow.find(tow.ends, 0.1, thrust, usual, start).converged());
  EXPECT_LT(start.force.norm(), 5.0);
}
}  // namespace tether_monitor::monitor
