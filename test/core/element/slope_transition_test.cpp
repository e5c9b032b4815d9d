#include "tether_monitor/core/element/slope_transition.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "support/matrix_compare.h"

namespace tether_monitor::core
{
namespace
{
const AxialParameters SOFT{20.0, 0.0, 1.0, 1e-5}, STIFF{1000.0, 0.0, 1.0, 1e-5};
const SlopeTransition TRANSITION{true, SOFT, STIFF, 1.01, 1.003};

// Slack, hardly taut, taut, and stretched by half.
const Vector3 SLOPES[] = {{0.3, -0.4, 0.2}, {0.6, -0.8, 0.1422}, {0.7, 0.7, 0.35}, {-1.2, 0.7, 0.6}};
const Vector3 RATE(0.3, -0.2, 0.9), FORCE(2.0, 1.0, -3.0);
}  // namespace

TEST(SlopeTransition, BothSidesCarryOneTensionInOneDirection)
{
  for (const Vector3& g : SLOPES)
  {
    const Vector3 s = SlopeMap(TRANSITION, g).slope();
    EXPECT_LT(s.cross(g).norm(), 1e-14);
    const double x = g.norm() / 1.01, y = s.norm() / 1.003;
    if (x > 1.0)
    {
      EXPECT_NEAR(y * (y * y - 1.0), 0.02 * x * (x * x - 1.0), 1e-14);
    }
    else
    {
      EXPECT_GT(y, x);
      EXPECT_LT(y, 1.0);
    }
  }
}

TEST(SlopeTransition, CurvesOfBothSidesCarryOneTension)
{
  SlopeTransition curved = TRANSITION;
  curved.softer.stiffening.count = curved.own.stiffening.count = 1;
  curved.softer.stiffening.strain[0] = 0.1;
  curved.softer.stiffening.change[0] = 5e4;
  curved.own.stiffening.strain[0] = 0.002;
  curved.own.stiffening.change[0] = -300.0;
  for (const Vector3& g : SLOPES)
  {
    const double x = g.norm() / 1.01, y = SlopeMap(curved, g).slope().norm() / 1.003;
    if (x > 1.0)
    {
      EXPECT_NEAR(y * axialResponse(curved.own, strainOfStretch(y)).force,
                  x * axialResponse(curved.softer, strainOfStretch(x)).force, 1e-9);
    }
    const double h = 1e-6;
    const SlopeMap map(curved, g), after(curved, g + h * RATE), before(curved, g - h * RATE);
    EXPECT_TRUE(matricesNear(map.rate(RATE), Vector3((after.slope() - before.slope()) / (2.0 * h)), 1e-7));
    EXPECT_TRUE(matricesNear(map.geometricStiffness(FORCE) * RATE,
                             Vector3((after.rate(FORCE) - before.rate(FORCE)) / (2.0 * h)), 1e-6));
  }
}

TEST(SlopeTransition, GoesOnSmoothlyWhereTheTensionEnds)
{
  const Vector3 unit(0.6, 0.0, 0.8);
  const auto at = [&](double x) { return SlopeMap(TRANSITION, 1.01 * x * unit).slope().norm() / 1.003; };
  EXPECT_NEAR(at(1.0), 1.0, 1e-14);
  EXPECT_NEAR((at(1.0 + 1e-6) - at(1.0)) / 1e-6, 0.02, 1e-6);
  EXPECT_NEAR((at(1.0) - at(1.0 - 1e-6)) / 1e-6, 0.02, 2e-6);
}

TEST(SlopeTransition, RatesAreDerivatives)
{
  const double h = 1e-6;
  for (const Vector3& g : SLOPES)
  {
    const SlopeMap map(TRANSITION, g), after(TRANSITION, g + h * RATE), before(TRANSITION, g - h * RATE);
    EXPECT_TRUE(matricesNear(map.rate(RATE), Vector3((after.slope() - before.slope()) / (2.0 * h)), 1e-8));
    EXPECT_TRUE(matricesNear(map.jacobian() * RATE, map.rate(RATE), 1e-14));
    EXPECT_TRUE(matricesNear(map.acceleration(RATE, Vector3::Zero()),
                             Vector3((after.rate(RATE) - before.rate(RATE)) / (2.0 * h)), 1e-8));
    EXPECT_TRUE(matricesNear(map.geometricStiffness(FORCE) * RATE,
                             Vector3((after.rate(FORCE) - before.rate(FORCE)) / (2.0 * h)), 1e-7));
  }
}

TEST(SlopeTransition, ALikeNeighbourChangesNothing)
{
  const Vector3 g(0.5, 0.8, 0.6);
  EXPECT_TRUE(matricesNear(SlopeMap(SlopeTransition{}, g).slope(), g, 1e-15));
  EXPECT_TRUE(matricesNear(SlopeMap(SlopeTransition{}, g).jacobian(), Matrix3(Matrix3::Identity()), 1e-14));
}

TEST(SlopeTransition, NoSlopeIsNoDivision)
{
  EXPECT_TRUE(SlopeMap(TRANSITION, Vector3::Zero()).jacobian().allFinite());
  EXPECT_TRUE(SlopeMap(TRANSITION, Vector3(1e6, 0.0, 0.0)).jacobian().allFinite());
}

}  // namespace tether_monitor::core
