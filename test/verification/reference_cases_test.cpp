// What bench/README.md claims of the cases A to F, without the times: error against a fine run, iterations,
// substeps.
#include <gtest/gtest.h>

#include <algorithm>

#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/solve/mesh_convergence.h"
#include "verification/reference_cases.h"

namespace tether_monitor::bench
{
namespace
{
Case caseNamed(const std::string& name)
{
  for (Case& c : cases())
    if (c.name == name)
      return c;
  return {};
}

Record fine(const Case& c, int elements, double step)
{
  core::StepperOptions options;
  options.step = step;
  options.newton.relative_tolerance = 1e-9;
  const Record record = run(c, elements, options);
  EXPECT_TRUE(record.complete) << c.name;
  return record;
}

Record usual(const Case& c, int elements, double step)
{
  core::StepperOptions options;
  options.step = step;
  const Record record = run(c, elements, options);
  EXPECT_TRUE(record.complete) << c.name;
  return record;
}

// RMS errors over the means.
struct Errors
{
  Deviation vessel, vehicle;
};
Errors errors(const Case& c, const Record& record, const Record& truth)
{
  return {deviation(c, record.vessel, truth.vessel, c.output),
          deviation(c, record.vehicle, truth.vehicle, c.output)};
}

double iterationsPerStep(const Record& r)
{
  return static_cast<double>(r.total.iterations) / r.total.steps;
}
}  // namespace

TEST(Cases, ATautTowWith50Elements)
{
  const Case c = caseNamed("A");
  const Record record = usual(c, 50, 0.05);
  const Errors e = errors(c, record, fine(c, 200, 0.0125));
  EXPECT_LT(e.vessel.rms, 2e-4);
  EXPECT_LT(e.vehicle.rms, 1e-3);
  EXPECT_LT(iterationsPerStep(record), 1.5) << "Newton converges fast with the symmetric tangent";
  EXPECT_EQ(record.total.rejected, 0);
}

TEST(Cases, BLowTensionWith50Elements)
{
  const Case c = caseNamed("B");
  const Errors e = errors(c, usual(c, 50, 0.05), fine(c, 200, 0.025));
  EXPECT_LT(e.vessel.rms, 1e-3);
  EXPECT_LT(e.vehicle.rms, 1e-2);
}

TEST(Cases, CBodyInHeaveWith10Elements)
{
  const Case c = caseNamed("C");
  const Errors e = errors(c, usual(c, 10, 0.05), fine(c, 100, 0.0125));
  EXPECT_LT(e.vessel.rms, 5e-4);
}

TEST(Cases, DBodyInTurnWith10Elements)
{
  const Case c = caseNamed("D");
  const Errors e = errors(c, usual(c, 10, 0.1), fine(c, 100, 0.02));
  EXPECT_LT(e.vessel.rms, 5e-4);
}

TEST(Cases, ESnapPeaksAndTheWorstStep)
{
  const Case c = caseNamed("E");
  const Record record = usual(c, 50, 0.05);
  const Errors e = errors(c, record, fine(c, 200, 0.002));
  EXPECT_LT(e.vessel.peak, 0.03);
  EXPECT_LT(e.vehicle.peak, 0.03);
  std::vector<int> iterations = record.iterations;
  std::nth_element(iterations.begin(), iterations.begin() + iterations.size() / 2, iterations.end());
  const int median = iterations[iterations.size() / 2];
  EXPECT_LE(record.worst_iterations, 10 * median);
  EXPECT_LE(record.worst_pieces, 10) << "the median is one";
}

TEST(Cases, FSlackBightFrom50ElementsOnAndCoarseBelow)
{
  const Case c = caseNamed("F");
  const Record truth = fine(c, 200, 0.025);
  for (const int elements : {50, 100})
    EXPECT_LT(errors(c, usual(c, elements, 0.05), truth).vessel.peak, 0.01) << elements;
  for (const int elements : {20, 32, 40})
  {
    core::CableModel model(c.tether, elements, c.sea);
    core::SteadyStateSolver statics(model.nodes());
    core::NodeField shape;
    ASSERT_TRUE(statics.solve(model, c.start, shape).converged());
    core::StationProfile stations(elements);
    core::computeStations(core::DeployedCable(model), core::CableState(0.0, shape, core::Vector3::Zero()),
                          stations);
    EXPECT_GT(stations.max_element_rotation, 1.2) << "the monitor says MESH_COARSE beyond";
  }
}

class ChosenMesh : public ::testing::TestWithParam<const char*>
{
};

TEST_P(ChosenMesh, KeepsTheAccuracyAtTheVesselEnd)
{
  const Case c = caseNamed(GetParam());
  constexpr double ACCURACY = 1e-3;
  const core::MeshSelection mesh = core::selectMesh(
      [&](int elements) { return core::CableModel(c.tether, elements, c.sea).withBodies(c.bodies); }, c.start,
      ACCURACY, core::StepperOptions());
  EXPECT_TRUE(mesh.converged);
  EXPECT_LT(mesh.elements, core::MOST_ELEMENTS);
  EXPECT_LT(errors(c, usual(c, mesh.elements, mesh.step), fine(c, 150, 0.02)).vessel.rms, ACCURACY);
}

INSTANTIATE_TEST_SUITE_P(Cases, ChosenMesh, ::testing::Values("A", "B", "C", "D"));

TEST(Kernels, AllGiveTheSameMotion)
{
  Case c = caseNamed("A");
  c.duration = 30.0;
  core::StepperOptions options;
  const Record first = run(c, 21, options, core::kernel::available().front());
  for (const core::kernel::Kernel* kernel : core::kernel::available())
  {
    const Record record = run(c, 21, options, kernel);
    ASSERT_EQ(record.vessel.size(), first.vessel.size()) << kernel->name;
    for (std::size_t i = 0; i < record.vessel.size(); ++i)
      ASSERT_NEAR(record.vessel[i], first.vessel[i], 1e-5 * first.vessel[i]) << kernel->name << ", sample " << i;
  }
}

}  // namespace tether_monitor::bench
