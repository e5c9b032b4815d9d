// A tether whose stiffness jumps by 1000, against its equilibrium equations integrated without elements.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "support/tethers.h"
#include "tether_monitor/core/assembly/end_forces.h"
#include "tether_monitor/core/solve/mesh_convergence.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LENGTH = 60.0, FROM = 20.0, TO = 35.0, STIFF = 2e6, SOFT = 2e3;

CableProperties tether()
{
  return plainCable(LENGTH, 0.012, 0.6, STIFF);
}

CableLayout bungee()
{
  CableSection soft{FROM, TO, tether()};
  soft.properties.axial_stiffness = SOFT;
  CableLayout layout;
  layout.sections = {soft};
  return layout;
}

// Stretch x at a tension T of N = EA eps x, (M3), (M4).
double stretchAt(double T, double EA)
{
  double x = 1.0 + std::min(0.5 * 2.0 * T / EA, std::cbrt(2.0 * T / EA));
  for (int i = 0; i < 60; ++i)
    x -= (0.5 * EA * x * (x * x - 1.0) - T) / (0.5 * EA * (3.0 * x * x - 1.0));
  return x;
}

// Span and drop of a tether that pulls its upper end with H and V; Gauss's three-point rule on short pieces.
Eigen::Vector2d reach(double H, double V, double w)
{
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  const auto add = [&](double from, double to, double EA)
  {
    constexpr int PIECES = 400;
    const double l = (to - from) / PIECES;
    for (int i = 0; i < PIECES; ++i)
      for (const auto& [x, weight] :
           {std::pair(-std::sqrt(0.6), 5.0 / 18.0), {0.0, 8.0 / 18.0}, {std::sqrt(0.6), 5.0 / 18.0}})
      {
        const double s = from + l * (i + 0.5 + 0.5 * x), v = V - w * s, T = std::hypot(H, v);
        sum += l * weight * stretchAt(T, EA) / T * Eigen::Vector2d(H, v);
      }
  };
  add(0.0, FROM, STIFF);
  add(FROM, TO, SOFT);
  add(TO, LENGTH, STIFF);
  return sum;
}

Eigen::Vector2d endForce(double span, double drop, double w)
{
  Eigen::Vector2d f(w * LENGTH, w * LENGTH);
  for (int i = 0; i < 60; ++i)
  {
    const Eigen::Vector2d miss = reach(f[0], f[1], w) - Eigen::Vector2d(span, drop);
    const double d = 1e-5 * w * LENGTH;
    Eigen::Matrix2d J;
    J << (reach(f[0] + d, f[1], w) - reach(f[0] - d, f[1], w)) / (2 * d),
        (reach(f[0], f[1] + d, w) - reach(f[0], f[1] - d, w)) / (2 * d);
    f -= J.inverse() * miss;
  }
  return f;
}

struct Case
{
  SteadyEnds ends;
  Eigen::Vector2d expected;

  Case()
  {
    ends.vessel = {0.0, 0.0, -10.0};
    ends.vehicle = {58.0, 0.0, -30.0};
    expected = endForce(58.0, 20.0, 9.81 * (0.6 - 1025.0 * tether().displacedArea()));
  }
  double error(const CableModel& model) const
  {
    const Vector3 force = steadyForces(model, ends).vessel;
    return (Eigen::Vector2d(force.x(), -force.z()) - expected).norm() / expected.norm();
  }
};
}  // namespace

TEST(StiffnessJump, EndForcesConvergeWithTheThirdOrderAtLeast)
{
  const Case hanging;
  double before = 0.0;
  for (const int elements : {8, 16, 32})
  {
    const double error = hanging.error(CableModel(tether(), elements, Environment(), bungee()));
    RecordProperty("error_" + std::to_string(elements), std::to_string(error));
    if (before > 0.0)
    {
      EXPECT_LT(error, std::max(before / 8.0, 1e-8)) << elements << " elements";
    }
    before = error;
  }
  EXPECT_LT(before, 1e-6);
}

TEST(StiffnessJump, AutoKeepsItsAccuracy)
{
  const Case hanging;
  const auto make = [](int elements) { return CableModel(tether(), elements, Environment(), bungee()); };
  StepperOptions options;
  const MeshSelection mesh = selectMesh(make, hanging.ends, 1e-3, options, 20);
  EXPECT_LT(hanging.error(make(mesh.elements)), 1e-3) << mesh.elements << " elements";
}

}  // namespace tether_monitor::core
