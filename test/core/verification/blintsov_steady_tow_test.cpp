// Steady tows with a free, loaded vehicle end, against a Runge-Kutta solution along the cable:
// golden/steady_tow.csv.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "support/tethers.h"

namespace tether_monitor::core
{
namespace
{
struct Row
{
  std::string name;
  std::vector<double> x;  // the columns behind the name
};

std::vector<Row> reference()
{
  std::ifstream in(std::string(PROJECT_DIR) + "/test/golden/steady_tow.csv");
  std::vector<Row> rows;
  std::string line, field;
  std::getline(in, line);
  while (std::getline(in, line))
  {
    std::istringstream fields(line);
    Row row;
    std::getline(fields, row.name, ',');
    while (std::getline(fields, field, ','))
      row.x.push_back(std::stod(field));
    rows.push_back(row);
  }
  return rows;
}

double near(double value)
{
  return std::max(1e-3 * std::abs(value), 0.05);
}
}  // namespace

TEST(SteadyTow, EveryReferenceCaseWith50Elements)
{
  const std::vector<Row> rows = reference();
  ASSERT_GE(rows.size(), 16u);
  for (const Row& row : rows)
  {
    SCOPED_TRACE(row.name);
    CableProperties p = towCable();
    p.length = row.x[0];
    p.diameter = row.x[1];
    p.mass_per_length = row.x[2];
    p.axial_stiffness = row.x[3];
    p.drag_normal = row.x[9] > 0.0 ? row.x[4] : 0.0;
    p.drag_tangential = row.x[9] > 0.0 ? row.x[5] : 0.0;
    CableModel model(p, 50, Environment());
    SteadyEnds ends;
    ends.velocity = {row.x[6], 0.0, 0.0};
    ends.vessel = {0.0, 0.0, -1.0};
    RigidBody body;
    body.inertia = Vector3::Ones();
    body.mass = 1025.0;
    body.volume = 1.0;  // neutral
    body.force = {row.x[7], 0.0, row.x[8]};
    model = model.withBodies({std::nullopt, body});
    SteadyStateSolver statics(model.nodes());
    NodeField shape;
    const SolveReport report = statics.solve(model, ends, shape);
    ASSERT_TRUE(report.converged()) << describe(report.status);
    const Vector3 relative = shape.back().head<3>() - ends.vessel;
    const EndForces forces = endForces(model, CableState(0.0, shape, ends.velocity));
    EXPECT_NEAR(-relative.z(), row.x[10], near(row.x[10])) << "depth";
    EXPECT_NEAR(-relative.x(), row.x[11], near(row.x[11])) << "layback";
    EXPECT_NEAR(forces.vessel.norm(), row.x[12], near(row.x[12])) << "tension at the vessel";
    EXPECT_NEAR(forces.vehicle.norm(), row.x[13], near(row.x[13])) << "tension at the vehicle";
    EXPECT_NEAR(std::atan2(-forces.vessel.z(), -forces.vessel.x()) * 180.0 / M_PI, row.x[14], 0.1) << "angle";
  }
}

TEST(SteadyTow, CriticalAngleOfALongTow)
{
  // cos(phi) = sqrt(1 + K^2) - K, K = w / (rho Cn d V^2): the angle of a cable that carries itself.
  CableProperties p = towCable();
  p.diameter = 0.0173;
  p.drag_normal = 1.5;
  p.drag_tangential = 0.0;
  p.mass_per_length = 8.89 / 9.81 + 1025.0 * p.displacedArea();
  p.length = 1000.0;
  const double angle[4][2] = {{0.5, 70.572}, {1.0, 43.933}, {2.0, 23.084}, {3.084, 15.099}};
  for (const auto& [V, phi] : angle)
  {
    CableModel model(p, 50, Environment());
    SteadyEnds ends;
    ends.velocity = {V, 0.0, 0.0};
    ends.vessel = {0.0, 0.0, -1.0};
    RigidBody body;
    body.mass = 1.0;
    body.volume = 1.0 / 1025.0;
    body.inertia = Vector3::Ones();
    model = model.withBodies({std::nullopt, body});
    SteadyStateSolver statics(model.nodes());
    NodeField shape;
    ASSERT_TRUE(statics.solve(model, ends, shape).converged()) << V;
    const Vector3 t = shape[25].tail<3>();
    EXPECT_NEAR(std::atan2(-t.z(), -t.x()) * 180.0 / M_PI, phi, 0.01 * phi) << "V = " << V;
  }
}

TEST(SteadyTow, ABodyFallsToTheDepthWhereDragAndWeightBalance)
{
  // Straight cable without weight and drag: the body hangs in the direction of its own force.
  CableProperties p = towCable();
  p.drag_normal = p.drag_tangential = 0.0;
  p.mass_per_length = 1025.0 * p.displacedArea();
  CableModel model(p, 20, Environment());
  SteadyEnds ends;
  ends.vessel = {0.0, 0.0, -1.0};
  ends.velocity = {2.0, 0.0, 0.0};
  RigidBody body;
  body.inertia = Vector3::Ones();
  body.mass = 1500.0;
  body.volume = 1.0;
  body.drag_area = {0.5, 0.5, 0.5};
  model = model.withBodies({std::nullopt, body});
  SteadyStateSolver statics(model.nodes());
  NodeField shape;
  ASSERT_TRUE(statics.solve(model, ends, shape).converged());
  const double drag = 0.5 * 1025.0 * 0.5 * 4.0, weight = 475.0 * 9.81;
  const Vector3 relative = shape.back().head<3>() - ends.vessel;
  EXPECT_NEAR(relative.x() / relative.z(), drag / weight, 1e-4);
  EXPECT_NEAR(endForces(model, CableState(0.0, shape, ends.velocity)).vehicle.norm(), std::hypot(drag, weight),
              1e-3);
}

}  // namespace tether_monitor::core
