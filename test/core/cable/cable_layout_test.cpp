#include "tether_monitor/core/cable/cable_layout.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <functional>

#include "support/matrix_compare.h"
#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
// A piece of elastic catenary: unstretched length, wet weight per metre, EA, and a point force (downwards) at its
// far end.
struct Piece
{
  double length, w, EA, weight_behind;
};

// Where a chain of pieces ends when it starts with the pull (H towards +x, V downwards) at the origin; z positive
// down.
Eigen::Vector2d endOf(const std::vector<Piece>& pieces, double H, double V, Eigen::Vector2d* first = nullptr)
{
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  for (const Piece& p : pieces)
  {
    const double after = V - p.w * p.length;
    at.x() += H * p.length / p.EA + H / p.w * (std::asinh(V / H) - std::asinh(after / H));
    at.y() += V * p.length / p.EA - 0.5 * p.w * p.length * p.length / p.EA +
              (std::hypot(H, V) - std::hypot(H, after)) / p.w;
    V = after - p.weight_behind;
    if (first)
    {
      *first = at;
      first = nullptr;
    }
  }
  return at;
}

// (H, V) at the origin for which the chain ends at `end`.
Eigen::Vector2d solve(const std::vector<Piece>& pieces, const Eigen::Vector2d& end, Eigen::Vector2d force)
{
  for (int i = 0; i < 300; ++i)
  {
    const Eigen::Vector2d miss = endOf(pieces, force[0], force[1]) - end;
    Eigen::Matrix2d J;
    const double d = 1e-4;
    for (int k = 0; k < 2; ++k)
      J.col(k) = (endOf(pieces, force[0] + d * (k == 0), force[1] + d * (k == 1)) -
                  endOf(pieces, force[0] - d * (k == 0), force[1] - d * (k == 1))) /
                 (2 * d);
    Eigen::Vector2d step = J.inverse() * miss;
    while (force[0] - step[0] <= 0.0)
      step *= 0.5;
    force -= 0.5 * step;
    if (step.norm() < 1e-9)
      break;
  }
  return force;
}

double wetWeight(const CableProperties& p)
{
  return (p.mass_per_length - 1025.0 * p.displacedArea()) * 9.81;
}
}  // namespace

class PointOnACatenary : public ::testing::TestWithParam<double>  // weight in water [N]
{
};

TEST_P(PointOnACatenary, MatchesThePiecewiseSolution)
{
  const double weight = GetParam();
  const CableProperties p = towCable();
  CableLayout layout;
  Attachment point{"it", 150.0, 0.0, 0.0, 0.0};
  if (weight > 0.0)
    point.mass = weight / 9.81;
  else
    point.volume = -weight / (1025.0 * 9.81);
  layout.attachments = {point};

  const double w = wetWeight(p);
  const std::vector<Piece> pieces{{150.0, w, p.axial_stiffness, weight}, {250.0, w, p.axial_stiffness, 0.0}};
  const Eigen::Vector2d force = solve(pieces, {330.0, 60.0}, {1500.0, 1500.0 + 0.7 * weight});
  ASSERT_LT((endOf(pieces, force[0], force[1]) - Eigen::Vector2d(330.0, 60.0)).norm(), 1e-6) << "precondition";
  Eigen::Vector2d place;
  endOf(pieces, force[0], force[1], &place);

  CableModel model(p, 50, Environment(), layout);
  const Vector3 vessel(0, 0, -100);
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  const SolveReport report = statics.solve(model, {vessel, {330, 0, -160}, {0, 0, 0}}, shape);
  ASSERT_TRUE(report.converged()) << describe(report.status);
  const EndForces forces = endForces(model, CableState(0.0, shape, Vector3::Zero()));
  EXPECT_TRUE(matricesNear(forces.vessel, Vector3(force[0], 0, -force[1]), 1e-3 * force.norm()));
  const Vector3 at = shape[model.lumpedAttachments()[0].node].head<3>() - vessel;
  EXPECT_TRUE(matricesNear(at, Vector3(place.x(), 0, -place.y()), 1e-3 * 150.0));
}

INSTANTIATE_TEST_SUITE_P(WeightAndFloat, PointOnACatenary, ::testing::Values(1500.0, -1200.0));

TEST(Sections, HeavyAndLightPiecesMatchThePiecewiseSolution)
{
  const CableProperties p = towCable();
  CableProperties chain = p;
  chain.mass_per_length = 5.0;
  chain.axial_stiffness = 2.0e7;
  CableLayout layout;
  layout.sections = {{0.0, 120.0, chain}};
  const std::vector<Piece> pieces{{120.0, wetWeight(chain), chain.axial_stiffness, 0.0},
                                  {280.0, wetWeight(p), p.axial_stiffness, 0.0}};
  const Eigen::Vector2d force = solve(pieces, {330.0, 60.0}, {3000.0, 4000.0});
  ASSERT_LT((endOf(pieces, force[0], force[1]) - Eigen::Vector2d(330.0, 60.0)).norm(), 1e-6) << "precondition";
  CableModel model(p, 50, Environment(), layout);
  const EndForces forces = steadyForces(model, {{0, 0, -100}, {330, 0, -160}, {0, 0, 0}});
  EXPECT_TRUE(matricesNear(forces.vessel, Vector3(force[0], 0, -force[1]), 1e-3 * force.norm()));
  EXPECT_EQ(model.elementProperties(0).mass_per_length, 5.0);
  EXPECT_EQ(model.elementProperties(49).mass_per_length, 1.43);
}

struct Fault
{
  const char* name;
  std::function<void(CableLayout&)> make;
};
class FittingsRefuse : public ::testing::TestWithParam<Fault>
{
};
TEST_P(FittingsRefuse, AndNameTheKey)
{
  CableLayout layout;
  layout.sections = {{0.0, 100.0, towCable()}, {100.0, 200.0, towCable()}};
  layout.attachments = {{"a", 50.0, 1.0, 0.0, 0.0}};
  ASSERT_TRUE(validate(layout, 400.0).empty()) << "precondition";
  GetParam().make(layout);
  const auto found = validate(layout, 400.0);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].find(GetParam().name), 0u) << found[0];
}
INSTANTIATE_TEST_SUITE_P(
    Bounds, FittingsRefuse,
    ::testing::Values(
        Fault{"tether.sections[0].from", [](CableLayout& f) { f.sections[0].from = -1.0; }},
        Fault{"tether.sections[0].from", [](CableLayout& f) { f.sections[0].from = 100.0; }},
        Fault{"tether.sections[1].to", [](CableLayout& f) { f.sections[1].to = 401.0; }},
        Fault{"tether.sections[1].from", [](CableLayout& f) { f.sections[1].from = 99.0; }},
        Fault{"tether.sections[1].diameter", [](CableLayout& f) { f.sections[1].properties.diameter = 0.0; }},
        Fault{"tether.attachments[0].s", [](CableLayout& f) { f.attachments[0].s = 400.0; }},
        Fault{"tether.attachments[0].mass", [](CableLayout& f) { f.attachments[0].mass = -1.0; }},
        Fault{"tether.attachments[0].volume", [](CableLayout& f) { f.attachments[0].volume = NAN; }},
        Fault{"tether.attachments[0].drag_area", [](CableLayout& f) { f.attachments[0].drag_area = -1.0; }}));

}  // namespace tether_monitor::core
