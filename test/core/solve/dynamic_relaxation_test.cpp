#include "tether_monitor/core/solve/dynamic_relaxation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/tethers.h"
#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::core
{
namespace
{
// A heavy chain, its far end held on a level floor 150 m down.
struct LaidChain
{
  explicit LaidChain(double friction, double axial_damping = 1e-3) : model(chain(axial_damping), 60, sea(friction))
  {
    ends.vessel = {0.0, 0.0, -10.0};
    ends.vehicle = {620.0, 0.0, -150.0 + 0.5 * 0.2};
  }

  static CableProperties chain(double axial_damping)
  {
    CableProperties p = plainCable(650.0, 0.2, 250.0, 1e9);
    p.axial_damping = axial_damping;
    return p;
  }
  static Environment sea(double friction)
  {
    Environment sea;
    sea.seabed = Seabed();
    sea.seabed->depth = 150.0;
    sea.seabed->friction = friction;
    return sea;
  }

  SolveReport settle()
  {
    SteadyStateSolver solver(model.nodes());
    NodeField shape;
    EXPECT_TRUE(findSteadyState(solver, model, ends, shape).converged());
    state = CableState(0.0, shape, Vector3::Zero());
    initializeContact(model, state);
    return settleContact(solver, model, ends, state);
  }

  CableModel model;
  SteadyEnds ends;
  CableState state;
};

// Tension H all along a frictionless floor of depth h below the vessel end, of a tether of length L that spans l:
// the elastic catenary from the touchdown on (Irvine 1981, ch. 1). Bisection on H.
double tensionOnSmoothFloor(double l, double h, double L, double w, double EA)
{
  double low = 1.0, high = 1e8;
  for (int i = 0; i < 200; ++i)
  {
    const double H = std::sqrt(low * high);
    double hanging = h;  // length whose height is h
    for (int k = 0; k < 100; ++k)
    {
      const double V = w * hanging;
      const double height = H / w * (std::hypot(1.0, V / H) - 1.0) + 0.5 * w * hanging * hanging / EA;
      hanging -= (height - h) / (V / H / std::hypot(1.0, V / H) + w * hanging / EA);
    }
    const double span = H / w * std::asinh(w * hanging / H) + H * L / EA + L - hanging;
    (span > l ? high : low) = H;
  }
  return std::sqrt(low * high);
}
}  // namespace

TEST(SettleContact, OnASmoothFloorBothEndsPullAlikeAndTheDampingDoesNotMatter)
{
  EndForces first;
  for (const double damping : {0.0, 1e-3, 0.1})
  {
    LaidChain laid(0.0, damping);
    ASSERT_TRUE(laid.settle().converged());
    const EndForces forces = endForces(laid.model, laid.state);
    EXPECT_NEAR(forces.vessel.x(), -forces.vehicle.x(), 1e-3 * std::abs(forces.vessel.x()));
    // It sinks into the floor by its weight over the floor's stiffness and half the soft start, and so hangs
    // deeper.
    const double w = 9.81 * (250.0 - 1025.0 * laid.chain(0.0).displacedArea());
    const double sunk = w / (0.2 * 3e5) + 0.5 * 0.02 * 0.2;
    const double expected = tensionOnSmoothFloor(620.0, 139.9 + sunk, 650.0, w, 1e9);
    EXPECT_NEAR(std::abs(forces.vessel.x()), expected, 3e-3 * expected);
    if (damping == 0.0)
      first = forces;
    EXPECT_LT((forces.vessel - first.vessel).norm(), 1e-5 * first.vessel.norm());
    EXPECT_LT((forces.vehicle - first.vehicle).norm(), 1e-5 * first.vehicle.norm());
  }
}

TEST(SettleContact, FrictionHoldsWhatItCan)
{
  LaidChain smooth(0.0), rough(0.8);
  ASSERT_TRUE(smooth.settle().converged());
  ASSERT_TRUE(rough.settle().converged());
  const double without = std::abs(endForces(smooth.model, smooth.state).vehicle.x());
  const double with = std::abs(endForces(rough.model, rough.state).vehicle.x());
  EXPECT_LT(with, 0.85 * without) << "the floor takes its part";
  CableState later = rough.state;
  const RestReport rest = watchRest(rough.model, Vector3::Zero(), 120.0, later);
  EXPECT_TRUE(rest.was_at_rest);
  EXPECT_EQ(later.q[30], rough.state.q[30]) << "what was at rest is left alone";
}

// Nothing bows it: a straight line, pushed together like a strut, would be an equilibrium too.
TEST(FindSteadyState, ANeutralSlackTetherDoesNotPush)
{
  CableProperties p = towCable();
  p.length = 100.0;
  p.diameter = 0.02;
  p.mass_per_length = 1025.0 * p.displacedArea();
  p.axial_stiffness = 1e6;
  const CableModel model(p, 20, Environment());
  for (const Vector3& vehicle : {Vector3(60.0, 0.0, -20.0), Vector3(0.0, 0.0, -60.0), Vector3(80.0, 0.0, -30.0)})
  {
    SteadyEnds ends;
    ends.vessel = {0.0, 0.0, -10.0};
    ends.vehicle = vehicle;
    SteadyStateSolver solver(model.nodes());
    NodeField shape;
    ASSERT_TRUE(findSteadyState(solver, model, ends, shape).isUsable());
    const EndForces forces = endForces(model, CableState(0.0, shape, Vector3::Zero()));
    EXPECT_LT(forces.vessel.norm(), 0.1) << vehicle.transpose();
    StationProfile profile(20);
    computeStations(DeployedCable(model), CableState(0.0, shape, Vector3::Zero()), profile);
    EXPECT_NEAR(profile.stretched_length, 100.0, 0.01);
  }
}

TEST(WatchRest, SeesAMotionAndFollowsIt)
{
  LaidChain laid(0.0);
  ASSERT_TRUE(laid.settle().converged());
  CableState pushed = laid.state;
  for (NodeCoords& v : pushed.v)
    v.head<3>() = Vector3(0.0, 0.5, 0.0);
  pushed.v.front().setZero();
  pushed.v.back().setZero();
  const RestReport rest = watchRest(laid.model, Vector3::Zero(), 30.0, pushed);
  EXPECT_FALSE(rest.was_at_rest);
  EXPECT_EQ(rest.solve.status, SolveStatus::NOT_AT_REST) << "30 s have no quiet minute";
  EXPECT_EQ(pushed.time, 0.0);
  EXPECT_GT((pushed.q[30] - laid.state.q[30]).head<3>().norm(), 0.1);
}

TEST(WatchRest, EndsInUniformMotionAreAtRest)
{
  CableModel model(towCable(), 20, Environment());
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -5.0};
  ends.vehicle = {-250.0, 0.0, -250.0};
  ends.velocity = {1.5, 0.0, 0.0};
  CableState state(3.0, steadyShape(model, ends), ends.velocity);
  const RestReport rest = watchRest(model, ends.velocity, 90.0, state);
  EXPECT_TRUE(rest.was_at_rest);
  EXPECT_EQ(state.time, 3.0);
}

}  // namespace tether_monitor::core
