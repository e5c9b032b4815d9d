// Tow from rest with a heaving vessel, both ends held, against MoorDyn with 400 segments: golden/heave_tow_A.csv.
// Vessel end (X, 0, -5 + s sin(2 pi t / 8)), vehicle end (-330 + X, 0, -155), X = 1.5 integral of s, s a smooth
// ramp of 20 s.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "support/tethers.h"
#include "tether_monitor/files/csv_table.h"

namespace tether_monitor::core
{
namespace
{
constexpr double RAMP = 20.0, SPEED = 1.5, OMEGA = 2.0 * M_PI / 8.0;

double ramp(double t)
{
  const double u = t / RAMP;
  return t < RAMP ? u - std::sin(2.0 * M_PI * u) / (2.0 * M_PI) : 1.0;
}
double rampRate(double t)
{
  return t < RAMP ? (1.0 - std::cos(2.0 * M_PI * t / RAMP)) / RAMP : 0.0;
}
double way(double t)
{
  const double u = std::min(t / RAMP, 1.0);
  return SPEED *
         (RAMP * (0.5 * u * u + (std::cos(2.0 * M_PI * u) - 1.0) / (4.0 * M_PI * M_PI)) + std::max(0.0, t - RAMP));
}
EndMotion vesselEnd(double t)
{
  const double s = std::sin(OMEGA * t), c = std::cos(OMEGA * t);
  return {{way(t), 0.0, -5.0 + ramp(t) * s}, {SPEED * ramp(t), 0.0, rampRate(t) * s + ramp(t) * OMEGA * c}};
}
EndMotion vehicleEnd(double t)
{
  return {{-330.0 + way(t), 0.0, -155.0}, {SPEED * ramp(t), 0.0, 0.0}};
}
}  // namespace

TEST(ReferenceTow, EndTensionsFollowMoorDynWith50Elements)
{
  const files::CsvTable reference = files::readCsv(std::string(PROJECT_DIR) + "/test/golden/heave_tow_A.csv");
  CableModel model(towCable(), 50, Environment());
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  ASSERT_TRUE(statics.solve(model, {{0, 0, -5}, {-330, 0, -155}, {0, 0, 0}}, shape).converged());
  CableState state(0.0, shape, Vector3::Zero());
  const EndForces start = endForces(model, state);
  EXPECT_NEAR(start.vessel.norm(), 2527.652, 0.01);
  EXPECT_NEAR(start.vehicle.norm(), 1489.584, 0.01);

  AdaptiveStepper stepper(model, StepperOptions());
  double vessel_error = 0.0, vehicle_error = 0.0, vessel_mean = 0.0, vehicle_mean = 0.0;
  int samples = 0;
  for (const auto& row : reference.rows)
  {
    const double t0 = state.time, t = row[0];
    const BoundaryConditions ends{EndTrajectory::between(t0, vesselEnd(t0), t, vesselEnd(t)),
                                  EndTrajectory::between(t0, vehicleEnd(t0), t, vehicleEnd(t))};
    ASSERT_TRUE(stepper.advance(model, ends, t, state).converged()) << "t = " << t;
    if (t <= RAMP)
      continue;
    const EndForces forces = endForces(model, state);
    vehicle_error += std::pow(forces.vehicle.norm() - row[7], 2);
    vessel_error += std::pow(forces.vessel.norm() - row[8], 2);
    vehicle_mean += row[7];
    vessel_mean += row[8];
    ++samples;
  }
  const double vessel = std::sqrt(vessel_error / samples) / (vessel_mean / samples);
  const double vehicle = std::sqrt(vehicle_error / samples) / (vehicle_mean / samples);
  RecordProperty("vessel_percent", std::to_string(100.0 * vessel));
  RecordProperty("vehicle_percent", std::to_string(100.0 * vehicle));
  // The reference itself is converged to 0.004 % and 0.07 %.
  EXPECT_LT(vessel, 2.0e-4);
  EXPECT_LT(vehicle, 1.0e-3);
}

}  // namespace tether_monitor::core
