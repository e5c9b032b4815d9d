#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "support/matrix_compare.h"
#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
RigidBody torpedo()
{
  RigidBody body;
  body.mass = 120.0;
  body.volume = 0.11;
  body.inertia = {8.0, 40.0, 45.0};
  body.drag_area = {0.1, 0.4, 0.5};
  body.added_mass = {10.0, 90.0, 80.0};
  body.added_inertia = {1.0, 20.0, 15.0};
  body.rotational_drag = {2.0, 30.0, 40.0};
  body.center_of_buoyancy = {0.05, 0.0, 0.1};
  body.force = {3.0, -2.0, 1.0};
  body.attachment = {0.6, 0.1, 0.2};
  body.wind_area = {0.3, 0.4, 0.1};
  return body;
}

// A tether too light and too soft to be felt, slack, so that its body is as good as alone.
CableModel alone(const RigidBody& body, const Environment& sea, double mass_per_length = 1e-9)
{
  CableProperties p;
  p.length = 1.0;
  p.diameter = 1e-6;
  p.mass_per_length = mass_per_length;
  p.axial_stiffness = 1e-12;
  p.working_load = p.breaking_load = 1.0;
  return CableModel(p, 1, sea).withBodies({std::nullopt, body});
}

CableState placed(const CableModel& model, const Vector3& attachment, const Vector3& velocity = Vector3::Zero())
{
  NodeField shape(2);
  shape[0] << attachment + Vector3::UnitX(), -Vector3::UnitX();
  shape[1] << attachment, -Vector3::UnitX();
  CableState state(0.0, shape, velocity);
  initializeContact(model, state);
  return state;
}

struct Simulated
{
  CableModel model;
  CableState state;
  BoundaryConditions ends;
  bool run(double duration, double step)
  {
    ends.vessel = EndTrajectory::uniform(state.time, {state.q[0].head<3>(), Vector3::Zero()});
    GeneralizedAlpha integrator(model, 1.0);
    StepperOptions options;
    options.step = step;
    options.spectral_radius = 1.0;
    options.newton.relative_tolerance = 1e-10;
    if (state.time == 0.0 && !integrator.initializeAcceleration(model, ends, state).converged())
      return false;
    return AdaptiveStepper(model, options).advance(model, ends, state.time + duration, state).converged();
  }
  const AttitudeState& rotation() const { return state.vehicle; }
};

Environment spaceSea()
{
  Environment space = air();
  space.gravity = 0.0;
  return space;
}
}  // namespace

class BodyTangent : public ::testing::TestWithParam<int>
{
};

TEST_P(BodyTangent, IsTheDerivative)
{
  RandomElement random(static_cast<unsigned>(GetParam()));
  RigidBody body = torpedo();
  const bool floats = GetParam() % 2 == 0;
  if (GetParam() % 3 == 0)
    body.hull = Hull{{6.0, 2.0, 1.5}, {0.1, 0.0, -0.6}};
  Environment sea;
  sea.wind = {5.0, 3.0, 0.0};
  // At the surface also the wet share changes: its part of drag and added mass is left out, so it moves little
  // there.
  const double motion = floats ? 0.02 : 1.0;
  const EnvironmentModel environment(sea);
  RigidBodyMotion at{
      0.0, Vector3(1, 2, floats ? 0.1 : -20.0), motion * random.vector(2.0), motion * random.vector(1.0), {}};
  AttitudeState& turned = at.attitude;
  const Vector3 axis = random.vector(1.0).normalized();  // drawn in the same order by every compiler
  turned.orientation = Eigen::Quaterniond(Eigen::AngleAxisd(random.uniform(-0.5, 0.5), axis));
  turned.velocity = motion * random.vector(0.5);
  turned.acceleration = motion * random.vector(0.4);
  const Wrench thrust{random.vector(30.0), random.vector(5.0)};
  const TangentWeights w{1.3, 0.7, 0.4};
  const RigidBodyResidual response = rigidBodyResidual(body, environment, at, thrust, w);
  const double h = 1e-6;
  Matrix3 force_n, moment_n, force_r, moment_r;
  for (int i = 0; i < 3; ++i)
  {
    const auto moved = [&](double by)
    {
      RigidBodyMotion m = at;
      m.position[i] += w.stiffness * by;
      m.velocity[i] += w.damping * by;
      m.acceleration[i] += w.mass * by;
      return rigidBodyResidual(body, environment, m, thrust, w);
    };
    const auto rotated = [&](double by)
    {
      RigidBodyMotion m = at;
      AttitudeState& r = m.attitude;
      r.orientation = r.orientation * Eigen::AngleAxisd(w.stiffness * by, Vector3::Unit(i));
      r.velocity[i] += w.damping * by;
      r.acceleration[i] += w.mass * by;
      return rigidBodyResidual(body, environment, m, thrust, w);
    };
    force_n.col(i) = (moved(h).force - moved(-h).force) / (2.0 * h);
    moment_n.col(i) = (moved(h).moment - moved(-h).moment) / (2.0 * h);
    force_r.col(i) = (rotated(h).force - rotated(-h).force) / (2.0 * h);
    moment_r.col(i) = (rotated(h).moment - rotated(-h).moment) / (2.0 * h);
  }
  // Columns of a hull that pierce the surface shift their centres a little: left out, some 1e-3 of the whole.
  const double size = floats ? 2e-2 : 1e-5;
  EXPECT_TRUE(matricesNear(response.force_n, force_n, size * force_n.norm()));
  EXPECT_TRUE(matricesNear(response.moment_n, moment_n, size * (moment_n.norm() + force_n.norm())));
  EXPECT_TRUE(matricesNear(response.force_r, force_r, size * (force_r.norm() + force_n.norm())));
  EXPECT_TRUE(matricesNear(response.moment_r, moment_r, size * moment_r.norm()));
}

INSTANTIATE_TEST_SUITE_P(Seeds, BodyTangent, ::testing::Range(1, 13));

TEST(FreeBody, TorqueFreeRotationKeepsMomentumAndEnergy)
{
  RigidBody body;
  body.mass = 10.0;
  body.inertia = {1.0, 2.0, 3.5};
  body.attachment = {0.3, -0.2, 0.1};
  Simulated sim{alone(body, spaceSea()), {}, {}};
  sim.state = placed(sim.model, Vector3(0, 0, 0));
  sim.state.vehicle.velocity = {0.4, 2.0, 0.3};  // about the middle axis: it tumbles
  sim.state.v[1].head<3>() = sim.state.vehicle.velocity.cross(body.attachment);  // centre of mass at rest
  const auto momentum = [&]
  { return Vector3(sim.rotation().orientation * body.inertia.cwiseProduct(sim.rotation().velocity)); };
  const auto energy = [&]
  { return 0.5 * sim.rotation().velocity.dot(body.inertia.cwiseProduct(sim.rotation().velocity)); };
  const Vector3 L = momentum();
  const double E = energy();
  const Vector3 centre = centreOfMass(body, sim.state.q[1].head<3>(), sim.rotation());
  double tumbled = 1.0;
  for (int k = 0; k < 20; ++k)
  {
    ASSERT_TRUE(sim.run(0.5, 0.002));
    tumbled = std::min(tumbled, sim.rotation().velocity.y() / 2.0);
  }
  EXPECT_LT(tumbled, -0.5) << "precondition: the middle axis is unstable";
  // Second order: 20 rad/s of tumbling times 0.002 s, squared, over ten seconds.
  EXPECT_LT((momentum() - L).norm(), 2e-3 * L.norm());
  EXPECT_NEAR(energy(), E, 2e-3 * E);
  EXPECT_LT((centreOfMass(body, sim.state.q[1].head<3>(), sim.rotation()) - centre).norm(), 1e-3);
}

TEST(FreeBody, RightsItselfAtTheFrequencyOfItsMetacentre)
{
  RigidBody body;
  body.mass = 102.5;
  body.volume = 0.1;
  body.inertia = {5.0, 9.0, 9.0};
  body.added_inertia = {0.0, 3.0, 0.0};
  body.center_of_buoyancy = {0.0, 0.0, 0.08};
  Simulated sim{alone(body, Environment()), {}, {}};
  sim.state = placed(sim.model, Vector3(0, 0, -30));
  sim.state.vehicle.orientation = Eigen::AngleAxisd(0.02, Vector3::UnitY());
  const double expected = std::sqrt(102.5 * 9.81 * 0.08 / 12.0);
  double before = 0.02, first = 0.0, last = 0.0;
  int crossings = 0;
  for (int k = 1; k < 3000 && crossings < 11; ++k)
  {
    ASSERT_TRUE(sim.run(0.01, 0.01));
    const double pitch = 2.0 * sim.rotation().orientation.y();
    if (before * pitch < 0.0)
    {
      last = sim.state.time - 0.01 * pitch / (pitch - before);
      if (crossings++ == 0)
        first = last;
    }
    before = pitch;
  }
  EXPECT_NEAR(M_PI * (crossings - 1) / (last - first), expected, 1e-3 * expected);
}

TEST(FreeBody, ReachesTheSpeedWhereDragEqualsThrust)
{
  RigidBody body = torpedo();
  body.wind_area.setZero();
  body.mass = 1025.0 * body.volume;
  body.center_of_buoyancy = {0.0, 0.0, 0.1};
  body.force = Vector3::Zero();
  body.added_mass = {20.0, 20.0, 20.0};  // else it would turn across the flow
  Simulated sim{alone(body, Environment()), {}, {}};
  sim.state = placed(sim.model, Vector3(0, 0, -50));
  sim.ends.vehicle_thrust.force = {100.0, 0.0, 0.0};
  ASSERT_TRUE(sim.run(60.0, 0.05));
  const double speed = std::sqrt(2.0 * 100.0 / (1025.0 * 0.1));
  EXPECT_NEAR(sim.state.v[1].x(), speed, 1e-4 * speed);
}

TEST(FreeBody, TurnsAtTheRateWhereDragEqualsTorque)
{
  RigidBody body = torpedo();
  body.wind_area.setZero();
  body.mass = 1025.0 * body.volume;
  body.center_of_buoyancy = {0.0, 0.0, 0.1};
  body.force = body.attachment = Vector3::Zero();
  Simulated sim{alone(body, Environment()), {}, {}};
  sim.state = placed(sim.model, Vector3(0, 0, -50));
  sim.ends.vehicle_thrust.torque = {0.0, 0.0, 10.0};
  ASSERT_TRUE(sim.run(60.0, 0.02));
  EXPECT_NEAR(sim.rotation().velocity.z(), std::sqrt(10.0 / 40.0), 1e-4);
}

TEST(FreeBody, LandsOnTheSeabedAndStays)
{
  RigidBody body = torpedo();
  body.wind_area.setZero();
  body.mass = 200.0;
  body.force = body.attachment = Vector3::Zero();
  body.center_of_buoyancy = {0.0, 0.0, 0.1};
  Environment sea;
  sea.seabed = Seabed();
  sea.seabed->depth = 60.0;
  sea.current = CurrentProfile(Vector3(0.3, 0.0, 0.0));
  Simulated sim{alone(body, sea), {}, {}};
  sim.state = placed(sim.model, Vector3(0, 0, -57));
  ASSERT_TRUE(sim.run(30.0, 0.05));
  const Vector3 landed = sim.state.q[1].head<3>();
  EXPECT_NEAR(landed.z(), -60.0 + 0.5 * std::cbrt(0.11), 0.02);
  ASSERT_TRUE(sim.run(60.0, 0.05));
  EXPECT_LT((sim.state.q[1].head<3>() - landed).norm(), 0.05) << "friction holds it in the current";
}

TEST(FreeBody, AHullFloatsAtItsDraftAndFollowsLongWaves)
{
  RigidBody ship;
  ship.hull = Hull{{20.0, 6.0, 4.0}, {0.0, 0.0, -1.5}};
  ship.mass = 1025.0 * 20.0 * 6.0 * 1.5;  // draft 1.5 m
  ship.inertia = ship.mass * Vector3(4.0, 35.0, 35.0);
  ship.drag_area = {10.0, 40.0, 120.0};
  ship.rotational_drag = {1e6, 1e7, 1e7};
  Environment sea;
  Simulated calm{alone(ship, sea), {}, {}};
  calm.state = placed(calm.model, Vector3(0, 0, 0.2));
  ASSERT_TRUE(calm.run(200.0, 0.1));
  EXPECT_NEAR(calm.state.q[1].z(), 0.0, 0.02);

  sea.waves.components = {{1.0, 400.0, 0.0, 0.0}};
  Simulated waves{alone(ship, sea), {}, {}};
  waves.state = placed(waves.model, Vector3(0, 0, 0));
  ASSERT_TRUE(waves.run(100.0, 0.1));
  double worst = 0.0, pitch = 0.0;
  for (int k = 0; k < 200; ++k)
  {
    ASSERT_TRUE(waves.run(0.1, 0.1));
    const Vector3 at = waves.state.q[1].head<3>();
    worst = std::max(
        worst, std::abs(at.z() - waves.model.environment().waves().elevation(at.x(), at.y(), waves.state.time)));
    pitch = std::max(pitch, std::abs(2.0 * waves.rotation().orientation.y()));
  }
  EXPECT_LT(worst, 0.12) << "a wave twenty times the hull lifts it like a float";
  EXPECT_NEAR(pitch, 2.0 * M_PI / 400.0, 0.3 * 2.0 * M_PI / 400.0) << "slope of the wave";
}

}  // namespace tether_monitor::core
