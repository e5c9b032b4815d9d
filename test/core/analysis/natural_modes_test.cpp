#include <gtest/gtest.h>

#include <cmath>

#include "support/tethers.h"
#include "tether_monitor/core/analysis/natural_modes.h"

namespace tether_monitor::core
{
namespace
{
struct Steady
{
  CableModel model;
  CableState state;
};

Steady steady(CableModel model, const SteadyEnds& ends)
{
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  EXPECT_TRUE(statics.solve(model, ends, shape).converged());
  CableState state(0.0, shape, ends.velocity);
  initializeContact(model, state);
  return {std::move(model), std::move(state)};
}

std::vector<double> frequencies(const std::vector<Mode>& modes, ModeKind kind)
{
  std::vector<double> found;
  for (const Mode& mode : modes)
    if (mode.kind == kind)
      found.push_back(mode.frequency);
  return found;
}
}  // namespace

TEST(Modes, TautStringInWaterAndBar)
{
  CableProperties p = towCable();
  p.length = 50.0;
  p.axial_stiffness = 1.0e6;
  p.bending_stiffness = 1e-6;
  Environment sea;
  sea.gravity = 0.0;
  SteadyEnds ends;
  ends.vessel = {0, 0, -100};
  ends.vehicle = {50.5, 0, -100};
  const double T = 1.0e6 * 0.5 * (1.01 * 1.01 - 1.0) * 1.01, m = 1.43, added = 1025.0 * M_PI / 4.0 * 9e-4;
  const Steady taut = steady(CableModel(p, 60, sea), ends);
  const std::vector<Mode> modes = naturalModes(taut.model, taut.state, 30);
  ASSERT_EQ(modes.size(), 30u);
  const std::vector<double> transverse = frequencies(modes, ModeKind::TRANSVERSE);
  const std::vector<double> axial = frequencies(modes, ModeKind::AXIAL);
  ASSERT_GE(transverse.size(), 10u);
  ASSERT_GE(axial.size(), 1u);
  // N per |r'|: the geometric stiffness of a string is T over its stretched slope.
  for (int n = 1; n <= 5; ++n)
    for (int twin = 0; twin < 2; ++twin)
      EXPECT_NEAR(transverse[2 * n - 2 + twin], n / 100.0 * std::sqrt(T / 1.01 / (m + added)), 1e-3 * n);
  const double c = std::sqrt(1.0e6 * 0.5 * (3.0 * 1.01 * 1.01 - 1.0) / m);
  EXPECT_NEAR(axial[0], c / 100.0, 2e-3 * axial[0]);
}

TEST(Modes, HeaveResonanceOfAHangingBody)
{
  CableProperties p = towCable();
  p.length = 200.0;
  p.axial_stiffness = 5.0e6;
  Environment sea;
  sea.water_density = 1025.0;
  RigidBody body;
  body.mass = 2000.0;
  body.volume = 0.5;
  body.added_mass = Vector3::Constant(300.0);
  body.inertia = Vector3::Constant(100.0);
  CableModel model(p, 30, sea);
  model = model.withBodies({std::nullopt, body});
  const Steady hanging = steady(model, SteadyEnds{Vector3(0, 0, -1), {}, Vector3::Zero()});
  const std::vector<double> axial = frequencies(naturalModes(hanging.model, hanging.state, 60), ModeKind::AXIAL);
  ASSERT_FALSE(axial.empty());
  const double k = 5.0e6 / 200.0;
  const double expected = std::sqrt(k / (2300.0 + 1.43 * 200.0 / 3.0)) / (2.0 * M_PI);
  EXPECT_NEAR(axial[0], expected, 0.01 * expected) << "a third of the tether's mass, as a first approximation";
}

TEST(Modes, HangingChain)
{
  CableProperties p = towCable();
  p.length = 30.0;
  p.bending_stiffness = 1e-3;
  CableModel model(p, 60, air());
  RigidBody nothing;
  nothing.mass = 1e-3;
  nothing.inertia = Vector3::Ones();
  model = model.withBodies({std::nullopt, nothing});
  const Steady chain = steady(model, SteadyEnds());
  const std::vector<Mode> modes = naturalModes(chain.model, chain.state, 6);
  const double zeros[] = {2.404825557695773, 5.520078110286311, 8.653727912911013};  // of the Bessel function J0
  for (int n = 0; n < 3; ++n)
    EXPECT_NEAR(modes[2 * n].frequency, zeros[n] * std::sqrt(9.81 / 30.0) / (4.0 * M_PI),
                5e-3 * modes[2 * n].frequency);
}

TEST(Modes, ShapesAreNormalised)
{
  CableModel model(towCable(), 20, Environment());
  SteadyEnds ends;
  ends.vessel = {0, 0, -5};
  ends.vehicle = {-330, 0, -155};
  const Steady sagging = steady(model, ends);
  const std::vector<Mode> modes = naturalModes(sagging.model, sagging.state, 8);
  ASSERT_EQ(modes.size(), 8u);
  for (std::size_t i = 0; i < modes.size(); ++i)
  {
    double largest = 0.0;
    for (const NodeCoords& node : modes[i].shape)
      largest = std::max(largest, node.head<3>().norm());
    EXPECT_GT(largest, 0.9);
    EXPECT_LE(largest, 1.0 + 1e-9);
    if (i > 0)
    {
      EXPECT_GE(modes[i].frequency, modes[i - 1].frequency);
    }
  }
}

}  // namespace tether_monitor::core
