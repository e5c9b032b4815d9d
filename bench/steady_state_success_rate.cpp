// Steady states of random tethers: bench_steady_states [COUNT [FIRST_SEED [FILE]]]. Each is solved with 50 and
// with 100 elements, its residual looked at once more, and both compared. Ends with "N passed, N failed".
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tether_monitor/core/assembly/contact_assembly.h"
#include "tether_monitor/core/solve/dynamic_relaxation.h"
#include "verification/random_tether.h"
#include "verification/reference_cases.h"

namespace
{
using namespace tether_monitor;  // NOLINT: a program of its own
using nlohmann::json;

constexpr int ELEMENTS = 50;
constexpr double SAME = 0.02;         // of the larger end tension and a hundredth of the weight
constexpr double LARGEST_TURN = 1.2;  // [rad] over an element: beyond, the monitor says MESH_COARSE
constexpr double STILL_RESIDUAL =
    1e-4;  // largest force at a node over a tenth of the dry weight and the reactions

struct Found
{
  core::SolveReport report;
  double cpu = 0.0, vessel = 0.0, vehicle = 0.0, turn = 0.0, residual = 0.0;
};

Found find(const fuzz::RandomTether& t, int elements)
{
  Found found;
  core::CableModel model(t.tether, elements, t.sea);
  model = model.withBodies(t.bodies);
  core::SteadyStateSolver statics(model.nodes());
  core::NodeField shape;
  const double begin = bench::cpuTime();
  found.report = core::findSteadyState(statics, model, t.ends, shape);
  found.cpu = bench::cpuTime() - begin;
  if (!found.report.converged())
    return found;
  core::CableState state(0.0, shape, t.ends.velocity);
  core::initializeContact(model, state);
  core::StationProfile stations(elements);
  core::computeStations(core::DeployedCable(model, state.deployment), state, stations);
  found.vessel = stations.ends.vessel.norm();
  found.vehicle = stations.ends.vehicle.norm();
  found.turn = stations.max_element_rotation;
  // The residual apart from the solver, by the kernel for every machine.
  model = model.withKernel(*core::kernel::available().back());
  core::NodeField residual(model.nodes());
  const core::DeployedCable cable(model, state.deployment);
  cable.assemble(state, residual);
  const double reaction = std::max(residual.front().head<3>().norm(), residual.back().head<3>().norm());
  for (int i = 1; i < elements; ++i)
    found.residual = std::max(found.residual, residual[i].head<3>().norm());
  found.residual /= 0.1 * cable.forceScale() + reaction;
  return found;
}

double quantile(std::vector<double>& sorted, double q)
{
  std::sort(sorted.begin(), sorted.end());
  return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))];
}
}  // namespace

int main(int count, char** words)
{
  const long runs = count > 1 ? std::atol(words[1]) : 1000;
  const long first = count > 2 ? std::atol(words[2]) : 1;
  long found = 0, found_fine = 0, unbalanced = 0, same = 0, coarse = 0, different = 0;
  std::vector<double> cpu;
  for (long seed = first; seed < first + runs; ++seed)
  {
    fuzz::RandomSource dice(static_cast<unsigned>(seed));
    const fuzz::RandomTether t = fuzz::plausibleTether(dice);
    const Found a = find(t, ELEMENTS), b = find(t, 2 * ELEMENTS);
    cpu.push_back(b.cpu);
    found += a.report.converged();
    found_fine += b.report.converged();
    for (const Found* one : {&a, &b})
      if (!one->report.converged())
        std::printf(
            "seed %ld, %d elements: %s (length %g m, diameter %g m, density %g kg/m^3, chord %g of the length)\n",
            seed, one == &a ? ELEMENTS : 2 * ELEMENTS, core::describe(one->report.status), t.tether.length,
            t.tether.diameter, t.tether.mass_per_length / t.tether.displacedArea(),
            (t.ends.vehicle - t.ends.vessel).norm() / t.tether.length);
    if (!a.report.converged() || !b.report.converged())
      continue;
    if (std::max(a.residual, b.residual) > STILL_RESIDUAL)
    {
      ++unbalanced;
      std::printf("seed %ld: residual %g\n", seed, std::max(a.residual, b.residual));
    }
    const double scale = std::max(b.vessel, b.vehicle) + 0.01 * 9.81 * t.tether.mass_per_length * t.tether.length;
    const double error = std::max(std::abs(a.vessel - b.vessel), std::abs(a.vehicle - b.vehicle)) / scale;
    if (error <= SAME)
      ++same;
    else if (a.turn > LARGEST_TURN)
      ++coarse;
    else
    {
      ++different;
      std::printf("seed %ld: end tensions differ by %.1f %%\n", seed, 100.0 * error);
    }
  }
  const json out{
      {"tethers", runs},
      {"found_50_elements", found},
      {"found_100_elements", found_fine},
      {"residual_too_large", unbalanced},
      {"same_with_twice_the_elements", same},
      {"different_and_flagged_MESH_COARSE", coarse},
      {"different_and_not_flagged", different},
      {"cpu_seconds_100_elements",
       {{"median", quantile(cpu, 0.5)}, {"p99", quantile(cpu, 0.99)}, {"largest", quantile(cpu, 1.0)}}}};
  std::printf("%s\n", out.dump(1).c_str());
  if (count > 3)
    std::ofstream(words[3]) << out.dump(1) << "\n";
  std::printf("%ld passed, %ld failed\n", found, runs - found);
  return found >= 0.995 * static_cast<double>(runs) ? 0 : 1;
}
