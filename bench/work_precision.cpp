// Work-precision of the cases A to F: bench_work_precision [CASES [FILE]]. Every number of elements with every
// step against a converged run; case A also against golden/heave_tow_A.csv by its test. Both integrators. JSON
// into FILE or on the screen.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "tether_monitor/core/solve/mesh_convergence.h"
#include "verification/reference_cases.h"

namespace
{
using namespace tether_monitor;  // NOLINT: a program of its own
using bench::Case;
using bench::Record;
using nlohmann::json;

constexpr int REPETITIONS = 3;  // the fastest counts

struct Run
{
  int elements;
  double step;
};

std::vector<Run> runsOf(const Case& c)
{
  if (c.name == "C" || c.name == "D")
    return {{5, 0.2},  {8, 0.2},   {10, 0.2},  {16, 0.2},  {10, 0.1}, {16, 0.1},
            {24, 0.1}, {10, 0.05}, {24, 0.05}, {48, 0.05}, {96, 0.05}};
  if (c.name == "E")
    return {{10, 0.05}, {20, 0.05}, {50, 0.05}, {100, 0.05}, {50, 0.02}, {100, 0.02}, {200, 0.02}};
  return {{10, 0.1},  {16, 0.1},  {24, 0.1},  {32, 0.1},   {48, 0.1},  {16, 0.05},   {20, 0.05},   {32, 0.05},
          {50, 0.05}, {64, 0.05}, {96, 0.05}, {160, 0.05}, {50, 0.02}, {100, 0.025}, {200, 0.0125}};
}

double median(std::vector<double> x)
{
  std::nth_element(x.begin(), x.begin() + x.size() / 2, x.end());
  return x[x.size() / 2];
}

json describe(const Case& c, int elements, double step, const Record& r, const Record& reference)
{
  json out{{"elements", elements}, {"step", step}, {"complete", r.complete}};
  if (!r.complete)
    return out;
  const bench::Deviation vessel = bench::deviation(c, r.vessel, reference.vessel, c.output);
  const bench::Deviation vehicle = bench::deviation(c, r.vehicle, reference.vehicle, c.output);
  const std::vector<double> iterations(r.iterations.begin(), r.iterations.end());
  out.update({{"vessel_rms", vessel.rms},
              {"vessel_peak", vessel.peak},
              {"vehicle_rms", vehicle.rms},
              {"vehicle_peak", vehicle.peak},
              {"cpu_seconds", r.cpu},
              {"times_real_time", c.duration / r.cpu},
              {"iterations_per_step", static_cast<double>(r.total.iterations) / r.total.steps},
              {"worst_over_median_iterations", r.worst_iterations / std::max(1.0, median(iterations))},
              {"worst_substeps", r.worst_pieces},
              {"worst_over_median_cpu", *std::max_element(r.times.begin(), r.times.end()) / median(r.times)}});
  return out;
}

Record fastest(const Case& c, int elements, const core::StepperOptions& options)
{
  Record best = bench::run(c, elements, options);
  for (int k = 1; k < REPETITIONS; ++k)
  {
    const Record again = bench::run(c, elements, options);
    if (again.cpu < best.cpu)
      best = again;
  }
  return best;
}

void show(const std::string& what, const json& r)
{
  if (!r["complete"].get<bool>())
  {
    std::fprintf(stderr, "  %-18s N %4d h %-7g not completed\n", what.c_str(), r["elements"].get<int>(),
                 r["step"].get<double>());
    return;
  }
  std::fprintf(
      stderr,
      "  %-18s N %4d h %-7.3g vessel %.2e vehicle %.2e peak %.2e %.2e  %7.0f x  %.2f its/step, worst %.1f x\n",
      what.c_str(), r["elements"].get<int>(), r["step"].get<double>(), r["vessel_rms"].get<double>(),
      r["vehicle_rms"].get<double>(), r["vessel_peak"].get<double>(), r["vehicle_peak"].get<double>(),
      r["times_real_time"].get<double>(), r["iterations_per_step"].get<double>(),
      r["worst_over_median_iterations"].get<double>());
}

// The same part by the implicit scheme with the same elements: at equal error, what each costs.
void compareWithImplicit(const Case& part, const Record& reference, json& runs)
{
  for (json& explicit_run : runs)
  {
    if (!explicit_run["complete"].get<bool>())
      continue;
    core::StepperOptions options;
    options.step = 0.05;
    const Record r = fastest(part, explicit_run["elements"].get<int>(), options);
    if (!r.complete)
      continue;
    Record cut = reference;
    cut.vessel.resize(r.vessel.size());
    cut.vehicle.resize(r.vessel.size());
    const json same = describe(part, explicit_run["elements"].get<int>(), options.step, r, cut);
    explicit_run["generalized_alpha_vessel_rms"] = same["vessel_rms"];
    explicit_run["cpu_over_generalized_alpha"] = explicit_run["cpu_seconds"].get<double>() / r.cpu;
    std::fprintf(stderr,
                 "  N %d: abarbanel_zwas takes %.0f x the CPU of generalized_alpha (vessel %.2e and %.2e)\n",
                 explicit_run["elements"].get<int>(), explicit_run["cpu_over_generalized_alpha"].get<double>(),
                 explicit_run["vessel_rms"].get<double>(), same["vessel_rms"].get<double>());
  }
}

json explicitRuns(const Case& c, const Record& reference)
{
  // The explicit scheme takes the steps that its limit allows, however long the bench's are; a part of the run
  // shows what the whole would cost.
  json runs = json::array();
  Case part = c;
  part.duration = std::min(c.duration, c.count_from + 20.0);
  for (const int elements : {5, 10, 20})
  {
    core::StepperOptions options;
    options.scheme = core::Scheme::ABARBANEL_ZWAS;
    options.step = c.output;
    options.max_iterations = 1000000;
    const Record r = bench::run(part, elements, options);
    const std::size_t whole = c.output == part.output ? reference.vessel.size() : 0;
    Record cut = reference;
    cut.vessel.resize(std::min(whole, static_cast<std::size_t>(std::lround(part.duration / part.output))));
    cut.vehicle.resize(cut.vessel.size());
    runs.push_back(describe(part, elements, c.output, r, cut));
    show("abarbanel_zwas", runs.back());
  }
  compareWithImplicit(part, reference, runs);
  return runs;
}

// elements: auto.
json automaticRuns(const Case& c, const Record& reference)
{
  json runs = json::array();
  for (const double accuracy : {1e-2, 1e-3, 1e-4})
  {
    const double begin = bench::cpuTime();
    const core::MeshSelection mesh = core::selectMesh(
        [&](int elements) { return core::CableModel(c.tether, elements, c.sea).withBodies(c.bodies); }, c.start,
        accuracy, core::StepperOptions());
    const double cpu = bench::cpuTime() - begin;
    core::StepperOptions options;
    options.step = mesh.step;
    json r = describe(c, mesh.elements, mesh.step, fastest(c, mesh.elements, options), reference);
    r["accuracy"] = accuracy;
    r["expected"] = mesh.error;
    r["choice_cpu_seconds"] = cpu;
    runs.push_back(r);
    show("auto " + std::to_string(accuracy), r);
  }
  return runs;
}

json workPrecision(const Case& c)
{
  json out{{"case", c.name}, {"what", c.what}, {"duration", c.duration}};
  core::StepperOptions options;
  options.step = c.reference_step;
  options.newton.relative_tolerance = 1e-9;
  std::fprintf(stderr, "%s, %s: reference with %d elements, %g s\n", c.name.c_str(), c.what.c_str(),
               c.reference_elements, c.reference_step);
  const Record reference = bench::run(c, c.reference_elements, options);
  out["reference"] = {
      {"elements", c.reference_elements}, {"step", c.reference_step}, {"complete", reference.complete}};
  if (!reference.complete)
    return out;

  out["generalized_alpha"] = json::array();
  for (const Run& run : runsOf(c))
  {
    options = core::StepperOptions();
    options.step = run.step;
    out["generalized_alpha"].push_back(
        describe(c, run.elements, run.step, fastest(c, run.elements, options), reference));
    show("generalized_alpha", out["generalized_alpha"].back());
  }

  out["abarbanel_zwas"] = explicitRuns(c, reference);
  out["auto"] = automaticRuns(c, reference);
  return out;
}

std::string machine()
{
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.rfind("model name", 0) == 0)
      return line.substr(line.find(':') + 2);
  return "unknown";
}
}  // namespace

int main(int count, char** words)
{
  const std::string wanted = count > 1 ? words[1] : "ABCDEF";
  json out{{"machine", machine()}, {"kernel", core::kernel::best().name}, {"cases", json::array()}};
  for (const Case& c : bench::cases())
    if (wanted.find(c.name) != std::string::npos)
      out["cases"].push_back(workPrecision(c));
  if (count > 2)
    std::ofstream(words[2]) << out.dump(1) << "\n";
  else
    std::cout << out.dump(1) << "\n";
  return 0;
}
