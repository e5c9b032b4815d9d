#include "tether_monitor/core/assembly/joined_elements.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/matrix_compare.h"
#include "support/tethers.h"
#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::core
{
namespace
{
// A tether with a soft piece and one of another natural length.
struct Jumps
{
  explicit Jumps(const Environment& sea, double bending = 2.0)
    : model(tether(bending), 12, sea, layout(bending)), state(0.0, NodeField(13), Vector3::Zero())
  {
    RandomElement random(5);
    for (int i = 0; i <= 12; ++i)
    {
      state.q[i] << Vector3(2.01 * i, 0.3 * std::sin(i), -10.0) + random.vector(0.02),
          Vector3(1.004, 0.1 * std::cos(i), 0.0) + random.vector(0.01);
      for (int k = 0; k < 6; ++k)
      {
        state.v[i][k] = random.uniform(-0.5, 0.5);
        state.a[i][k] = random.uniform(-0.5, 0.5);
      }
    }
  }
  static CableProperties tether(double bending)
  {
    CableProperties p = towCable();
    p.length = 24.0;
    p.axial_stiffness = 1e6;
    p.axial_damping = 0.0;
    p.bending_stiffness = bending;
    return p;
  }
  static CableLayout layout(double bending)
  {
    CableLayout layout;
    CableSection soft{8.0, 12.0, tether(bending)}, worn{16.0, 18.0, tether(bending)};
    soft.properties.axial_stiffness = 2e4;
    worn.properties.permanent_elongation = 0.01;
    layout.sections = {soft, worn};
    return layout;
  }

  CableModel model;
  CableState state;
};
}  // namespace

TEST(JoinedElements, OnlyTheStifferSideFollows)
{
  const Jumps jumps(air());
  const DeployedCable cable(jumps.model);
  std::vector<int> joined;
  for (int i = 0; i < cable.elements(); ++i)
    if (cable.element(i).isJoined())
      joined.push_back(i);
  EXPECT_EQ(joined, (std::vector<int>{3, 6, 8, 9}));
  EXPECT_TRUE(cable.element(3).at_b.active);
  EXPECT_TRUE(cable.element(6).at_a.active);
}

TEST(JoinedElements, ForceIsTheGradientOfTheEnergy)
{
  Jumps jumps(air());
  for (NodeField* rate : {&jumps.state.v, &jumps.state.a})
    for (NodeCoords& x : *rate)
      x.setZero();
  const DeployedCable cable(jumps.model);
  NodeField residual(13);
  cable.assemble(jumps.state, residual);
  const double h = 1e-6;
  double size = 0.0;
  for (const NodeCoords& row : residual)
    size = std::max(size, row.norm());
  for (int node = 0; node <= 12; ++node)
    for (int k = 0; k < 6; ++k)
    {
      NodeField up = jumps.state.q, down = jumps.state.q;
      up[node][k] += h;
      down[node][k] -= h;
      const double slope =
          (cable.energy(up, jumps.state.v).total() - cable.energy(down, jumps.state.v).total()) / (2 * h);
      EXPECT_NEAR(residual[node][k], slope, 1e-5 * size) << node << ", " << k;
    }
}

TEST(JoinedElements, TangentIsTheDerivativeOfTheResidual)
{
  Environment sea;
  sea.current = CurrentProfile(Vector3(0.4, -0.3, 0.1));
  const Jumps jumps(sea);
  const DeployedCable cable(jumps.model);
  // What the map's change of velocity and inertia with the slope adds is left out: rates at rest for the
  // stiffness.
  CableState still = jumps.state;
  for (NodeField* rate : {&still.v, &still.a})
    for (NodeCoords& x : *rate)
      x.setZero();
  const auto check =
      [&](const CableState& state, NodeField CableState::*part, const TangentWeights& w, double tolerance)
  {
    NodeField residual(13), above(13), below(13);
    BlockTridiagonal tangent(13);
    cable.assemble(state, w, residual, tangent);
    double scale = 0.0;
    for (int n = 0; n <= 12; ++n)
      scale = std::max(scale, tangent.diagonal(n).norm());
    const double h = part == &CableState::a ? 1.0 : 1e-6;
    for (int node = 0; node <= 12; ++node)
      for (int k = 0; k < 6; ++k)
      {
        CableState up = state, down = state;
        (up.*part)[node][k] += h;
        (down.*part)[node][k] -= h;
        cable.assemble(up, above);
        cable.assemble(down, below);
        EXPECT_TRUE(matricesNear(NodeCoords(tangent.diagonal(node).col(k)),
                                 NodeCoords((above[node] - below[node]) / (2 * h)), tolerance * scale));
        if (node < 12)
        {
          EXPECT_TRUE(matricesNear(NodeCoords(tangent.lower(node).col(k)),
                                   NodeCoords((above[node + 1] - below[node + 1]) / (2 * h)), tolerance * scale));
        }
      }
  };
  check(still, &CableState::q, {0.0, 0.0, 1.0}, 1e-6);
  check(jumps.state, &CableState::v, {0.0, 1.0, 0.0}, 5e-3);
  check(jumps.state, &CableState::a, {1.0, 0.0, 0.0}, 1e-6);
}

// In space, without damping: what is given to it stays.
TEST(JoinedElements, EnergyAndMomentumStayWhileItSwingsAndGoesSlack)
{
  Environment space = air();
  space.gravity = 0.0;
  Jumps jumps(space, 0.0);
  CableState& state = jumps.state;
  RigidBody ball;
  ball.mass = 5.0;
  ball.inertia = Vector3::Constant(1e6);  // does not turn
  const CableModel model = jumps.model.withBodies({ball, ball});
  for (int i = 0; i <= 12; ++i)
  {
    state.q[i] << 2.01 * i, 0.0, 0.0, 1.005, 0.0, 0.0;
    state.v[i] << 0.3 * std::sin(0.4 * i), 0.5 * std::sin(0.5 * i), 0.2, 0.0, 0.0, 0.0;
    state.a[i].setZero();
  }
  const DeployedCable cable(model);
  const auto energy = [&]
  {
    return cable.energy(state.q, state.v).total() +
           2.5 * (state.v.front().head<3>().squaredNorm() + state.v.back().head<3>().squaredNorm());
  };
  StepperOptions options;
  options.step = 2e-4;
  options.spectral_radius = 1.0;
  AdaptiveStepper stepper(model, options);
  GeneralizedAlpha integrator(model, 1.0);
  ASSERT_TRUE(integrator.initializeAcceleration(model, BoundaryConditions(), state).converged());
  const double before = energy();
  ASSERT_TRUE(stepper.advance(model, BoundaryConditions(), 1.0, state).converged());
  EXPECT_NEAR(energy(), before, 2e-3 * before);
}

}  // namespace tether_monitor::core
