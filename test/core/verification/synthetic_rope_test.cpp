// A rope with a measured curve and a wire in one line, neutral in the water: one tension, two elongations.
#include <gtest/gtest.h>

#include "support/tethers.h"
#include "tether_monitor/core/assembly/end_forces.h"

namespace tether_monitor::core
{
namespace
{
constexpr double ROPE = 30.0, WIRE = 10.0, WIRE_EA = 2e6;
const std::vector<StrainTension> CURVE{{0.05, 200.0}, {0.15, 1500.0}, {0.25, 6000.0}};

CableProperties neutral(double length, double EA)
{
  CableProperties p = plainCable(length, 0.02, 1.0, EA);
  p.mass_per_length = Environment().water_density * p.displacedArea();
  return p;
}

CableModel ropeAndWire(int elements)
{
  CableProperties rope = neutral(ROPE + WIRE, 0.0);
  const AxialCurve curve = axialCurve(CURVE);
  rope.axial_stiffness = curve.stiffness;
  rope.axial_stiffening = curve.stiffening;
  CableLayout layout;
  layout.sections = {{ROPE, ROPE + WIRE, neutral(WIRE, WIRE_EA)}};
  return CableModel(rope, elements, Environment(), layout);
}
}  // namespace

TEST(SyntheticRope, CarriesWhatItsCurveSays)
{
  for (const auto& [elongation, tension] : {std::pair(0.025, 0.0), {0.05, 200.0}, {0.15, 1500.0}, {0.25, 6000.0}})
  {
    const double x = 1.0 + elongation;
    const AxialCurve curve = axialCurve(CURVE);
    const double T = tension > 0.0 ? tension : x * curve.stiffness * strainOfStretch(x);
    SteadyEnds ends;
    ends.vessel = {0.0, 0.0, -20.0};
    ends.vehicle = {ROPE * x + WIRE * stretchAtTension({WIRE_EA, 0.0, 1.0, 0.0}, T), 0.0, -20.0};
    const EndForces forces = steadyForces(ropeAndWire(8), ends);
    EXPECT_NEAR(forces.vessel.norm(), T, 1e-6 * T) << elongation;
    EXPECT_NEAR(forces.vehicle.norm(), T, 1e-6 * T) << elongation;
  }
}

}  // namespace tether_monitor::core
