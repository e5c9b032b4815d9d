// How good forecasts of over-tension are when tether, water and vehicle are not known well: truths that are drawn
// from what is told. Prints tables and writes a file.
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>

#include "verification/forecast_study.h"

namespace tether_monitor::bench
{
namespace
{
constexpr unsigned SEEDS_APART = 1000;

nlohmann::json print(const std::string& what, bool has_load_cell, int runs, double cpu,
                     const monitor::ForecastScore::Result& r)
{
  std::printf("%-45s %d | %3d runs | %3ld events | ", what.c_str(), has_load_cell, runs, r.events);
  nlohmann::json row{{"what", what}, {"load_cell", has_load_cell}, {"runs", runs},
                     {"cpu", cpu},   {"events", r.events},         {"brier_score", r.brier_score}};
  for (const monitor::ForecastScore::Warnings& w : r.warnings)
  {
    std::printf("from %.0f %%: %ld warned, median %.0f s, %ld warnings, %ld false | ", 100.0 * w.probability,
                w.warned, w.median_lead_time, w.warnings, w.false_warnings);
    row["warnings"].push_back({{"from_probability", w.probability},
                               {"warned", w.warned},
                               {"median_lead_time", w.median_lead_time},
                               {"warnings", w.warnings},
                               {"false_warnings", w.false_warnings}});
  }
  for (const monitor::ForecastScore::Reliability& b : r.reliability)
  {
    std::printf("%.0f: %.0f (%ld) ", 100.0 * b.mean_probability, 100.0 * b.observed, b.forecasts);
    row["reliability"].push_back(
        {{"forecasts", b.forecasts}, {"mean_probability", b.mean_probability}, {"came_true", b.observed}});
  }
  std::printf("| %.3f s\n", cpu);
  std::fflush(stdout);
  return row;
}
}  // namespace
}  // namespace tether_monitor::bench

// bench_forecast FILE [DRAWS] [FIRST_SEED]
int main(int argc, char** argv)
{
  using namespace tether_monitor;
  if (argc < 2)
  {
    std::cerr << "usage: bench_forecast FILE [DRAWS] [FIRST_SEED]\n";
    return 2;
  }
  const int draws = argc > 2 ? std::atoi(argv[2]) : 50;
  unsigned seed = argc > 3 ? static_cast<unsigned>(std::atoi(argv[3])) : 1000;
  std::printf(
      "case, load cell | runs | events | warnings from a probability on | forecast %%: came true %% (forecasts) | "
      "a forecast [s]\n");
  nlohmann::json rows = nlohmann::json::array();
  // It may take an hour: what there is, is kept.
  const auto keep = [&](nlohmann::json row)
  {
    rows.push_back(std::move(row));
    std::ofstream(argv[1]) << rows.dump(1) << "\n";
  };
  // No tether is drawn twice: thirty dives of five tethers tell of five.
  for (const bool has_load_cell : {false, true})
  {
    monitor::ForecastScore total;
    int runs = 0;
    double cpu = 0.0;
    for (const bench::Manoeuvre& manoeuvre : bench::manoeuvres())
    {
      const bench::ForecastStudy study = bench::studyForecasts(manoeuvre, draws, seed, has_load_cell, total);
      seed += bench::SEEDS_APART;
      keep(bench::print(manoeuvre.what, has_load_cell, study.runs, study.cpu, study.result));
      runs += study.runs;
      cpu = std::max(cpu, study.cpu);
    }
    keep(bench::print("all", has_load_cell, runs, cpu, total.result()));
  }
  return 0;
}
