#include "tether_monitor/core/solve/steady_state_solver.h"

#include <gtest/gtest.h>

#include "support/matrix_compare.h"
#include "support/tethers.h"
#include "tether_monitor/core/assembly/prescribed_ends.h"

namespace tether_monitor::core
{
struct EndsCase
{
  const char* name;
  SteadyEnds ends;
  double doubling_tolerance;  // relative, vessel-end tension between 50 and 100 elements
};

void PrintTo(const EndsCase& c, std::ostream* out)
{
  *out << c.name;
}

class SteadyState : public ::testing::TestWithParam<EndsCase>
{
};

TEST_P(SteadyState, IsFoundIsAnEquilibriumAndStaysWhenElementsAreDoubled)
{
  const SteadyEnds ends = GetParam().ends;
  Vector3 force[2];
  for (int k = 0; k < 2; ++k)
  {
    CableModel model(towCable(), k == 0 ? 50 : 100, Environment());
    SteadyStateSolver statics(model.nodes());
    NodeField shape;
    const SolveReport report = statics.solve(model, ends, shape);
    ASSERT_TRUE(report.converged()) << describe(report.status);

    // Second look at the residual, apart from the solver.
    const CableState state(0.0, shape, ends.velocity);
    NodeField residual(model.nodes());
    const DeployedCable cable(model, state.deployment);
    cable.assemble(state, residual);
    force[k] = -residual.front().head<3>();
    NewtonOptions tolerance;
    tolerance.relative_tolerance = 1e-7;
    const ResidualSize size = imposePrescribedEnds(cable, state.q, tolerance, PrescribedEnds(), residual);
    EXPECT_LE(size.largest, size.tolerance);
    EXPECT_TRUE(matricesNear(shape.front().head<3>(), ends.vessel, 1e-9));
    EXPECT_TRUE(matricesNear(shape.back().head<3>(), ends.vehicle, 1e-9));
  }
  EXPECT_NEAR(force[0].norm(), force[1].norm(), GetParam().doubling_tolerance * force[1].norm());
}

INSTANTIATE_TEST_SUITE_P(
    Ends, SteadyState,
    ::testing::Values(EndsCase{"bowed by weight", {{0, 0, -5}, {-330, 0, -155}, {0, 0, 0}}, 1e-4},
                      EndsCase{"slack", {{0, 0, -5}, {-100, 0, -50}, {0, 0, 0}}, 1e-4},
                      EndsCase{"bowed by drag", {{0, 0, -5}, {-300, 0, -100}, {0, 2, 0}}, 1e-4},
                      EndsCase{"towed", {{0, 0, -5}, {-392, 0, -60}, {3, 0, 0}}, 1e-3},
                      EndsCase{"pushed by the flow", {{0, 0, -5}, {-330, 0, -155}, {-1.5, 0, 0}}, 1e-4},
                      EndsCase{"slack bight in the flow", {{0, 0, -5}, {-100, 0, -50}, {1.5, 0, 0}}, 0.05},
                      EndsCase{"nearly straight", {{0, 0, -5}, {-399.9, 0, -5}, {0, 0, 0}}, 1e-3},
                      EndsCase{"vertical, taut", {{0, 0, -5}, {0, 0, -406}, {0, 0, 0}}, 1e-4},
                      EndsCase{"vertical, slack", {{0, 0, -5}, {0, 0, -300}, {0, 0, 0}}, 1e-2},
                      EndsCase{"vehicle above vessel", {{0, 0, -300}, {50, 20, -10}, {0, 0, 0}}, 1e-2},
                      EndsCase{"chord 5 % of the length", {{0, 0, -5}, {-20, 0, -5}, {0, 0, 0}}, 1e-3},
                      EndsCase{"no chord", {{0, 0, -5}, {0, 0, -5}, {0, 0, 0}}, 1e-3},
                      EndsCase{"chord 0.5 % too long", {{0, 0, -5}, {-402, 0, -5}, {0, 0, 0}}, 1e-4},
                      EndsCase{"emerged", {{0, 0, 10}, {-300, 0, -100}, {0, 0, 0}}, 1e-3}));

TEST(SteadyState, StretchedChordHasTheTensionOfItsStrain)
{
  CableModel model(towCable(), 20, Environment());
  const double strain = 0.5 * (1.005 * 1.005 - 1.0);
  EXPECT_NEAR(steadyForces(model, {{0, 0, -5}, {-402, 0, -5}, {0, 0, 0}}).vessel.norm(), 6.75e7 * strain * 1.005,
              1e-3 * 3.4e5);
}

TEST(SteadyState, MovingThroughStillWaterEqualsStandingInACurrent)
{
  Environment current;
  current.current = CurrentProfile(Vector3(-1.0, 0.4, 0.0));
  const EndForces moving =
      steadyForces(CableModel(towCable(), 20, Environment()), {{0, 0, -5}, {-350, 0, -90}, {1.0, -0.4, 0.0}});
  const EndForces standing =
      steadyForces(CableModel(towCable(), 20, current), {{0, 0, -5}, {-350, 0, -90}, {0, 0, 0}});
  EXPECT_TRUE(matricesNear(moving.vessel, standing.vessel, 1e-6 * standing.vessel.norm()));
}

TEST(SteadyState, TheNumberOfElementsDoesNotDecideWhatCountsAsBalance)
{
  CableProperties p = towCable();
  p.length = 150.0;
  p.diameter = 0.017;
  p.mass_per_length = 0.24;  // of which the water carries all but 3 %
  p.axial_stiffness = 4e6;
  SteadyEnds ends;
  ends.vehicle = {80.0, 0.0, -100.0};
  const double few = steadyForces(CableModel(p, 1000, Environment()), ends).vessel.norm();
  const double many = steadyForces(CableModel(p, 4000, Environment()), ends).vessel.norm();
  EXPECT_NEAR(few, 9.62, 0.1);
  EXPECT_NEAR(many, few, 1e-2 * few);
}

TEST(SteadyState, GarbageEndsInAStatusAndLeavesTheShapeAlone)
{
  CableModel model(towCable(), 10, Environment());
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  EXPECT_FALSE(statics.solve(model, {{0, 0, NAN}, {-300, 0, -50}, {0, 0, 0}}, shape).converged());
  EXPECT_TRUE(shape.empty());
}

}  // namespace tether_monitor::core
