// How honest and how good mode observed is when tether, water and vehicle are not known well: truths that are
// drawn from what is told, and tows in which one thing is configured wrong. Prints tables and writes a file.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <string>

#include "verification/estimation_study.h"

namespace tether_monitor::bench
{
namespace
{
nlohmann::json toJson(const PooledScore& s)
{
  return {{"mean", s.mean}, {"rms", s.rms},           {"band", s.band},
          {"nees", s.nees}, {"within_1", s.within_1}, {"within_90", s.within_90}};
}

nlohmann::json toJson(const StudyResult& r)
{
  return {{"vessel", toJson(r.vessel)},
          {"vehicle", toJson(r.vehicle)},
          {"position_rms", r.position_rms},
          {"position_within_2", r.position_within_2},
          {"within_2", r.within_2},
          {"ok", r.ok},
          {"valid", r.valid},
          {"implausible", r.implausible},
          {"disagreement", r.disagreement},
          {"sure_and_wrong", r.sure_and_wrong},
          {"limit_alarms", r.limit_alarms},
          {"hours", r.hours},
          {"runs", r.runs},
          {"cpu", r.cpu},
          {"vessel_rms", r.vessel_rms},
          {"vehicle_rms", r.vehicle_rms}};
}

double meanOf(const std::vector<double>& x)
{
  return x.empty() ? 0.0 : std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

void print(const PooledScore& s)
{
  std::printf(" %7.1f %6.1f %6.1f %5.2f %4.0f %4.0f |", s.mean, s.rms, s.band, s.nees, 100.0 * s.within_1,
              100.0 * s.within_90);
}

void printStatus(const StudyResult& r)
{
  std::printf(" %3.0f %3.0f %3.0f %5.1f |", 100.0 * r.ok, 100.0 * r.implausible, 100.0 * r.disagreement,
              r.sure_and_wrong);
}

nlohmann::json pooledRow(const UncertainCase& c, int draws, double latency, bool has_load_cell)
{
  StudyOptions options;
  options.draws = draws;
  options.latency = latency;
  options.has_load_cell = has_load_cell;
  const StudyResult r = studyPooled(c, options);
  std::printf("%s %.0f %d |", c.of.name.c_str(), latency, has_load_cell);
  print(r.vessel);
  print(r.vehicle);
  std::printf(" %.2f %3.0f |", r.position_rms, 100.0 * r.position_within_2);
  printStatus(r);
  std::printf(" %d in %.1f h | %.2f\n", r.limit_alarms, r.hours, 100.0 * r.cpu);
  std::fflush(stdout);
  nlohmann::json row = toJson(r);
  row["case"] = c.of.name;
  row["latency"] = latency;
  row["load_cell"] = has_load_cell;
  return row;
}

nlohmann::json pooled(const std::vector<UncertainCase>& cases, const std::string& wanted,
                      std::initializer_list<double> latencies, int draws)
{
  std::printf(
      "case, latency, load cell | vessel: mean, rms, band [N], NEES, within 1 sigma, 5..95 %% | vehicle: the "
      "same | position rms, 2 sigma | OK, IMPLAUSIBLE, DISAGREEMENT %%, longest sure and wrong [s] | "
      "false limit alarms | %% of a core\n");
  nlohmann::json rows = nlohmann::json::array();
  for (const UncertainCase& c : cases)
    for (const double latency : latencies)
      for (const bool has_load_cell : {false, true})
        if (wanted.find(c.of.name) != std::string::npos)
          rows.push_back(pooledRow(c, draws, latency, has_load_cell));
  return rows;
}

nlohmann::json misconfigured(const std::string& wanted)
{
  std::printf(
      "case, configured wrong | positions: rms over mean, band, within 2 sigma | OK, IMPLAUSIBLE, "
      "DISAGREEMENT %%, longest sure and wrong [s] | with load cell\n");
  nlohmann::json rows = nlohmann::json::array();
  for (const UncertainCase& c : uncertainCases())
    for (const Misconfiguration& fault : misconfigurations())
    {
      if (!c.is_towed || wanted.find(c.of.name) == std::string::npos)
        continue;
      std::printf("%s %-40s |", c.of.name.c_str(), fault.what.c_str());
      for (const bool has_load_cell : {false, true})
      {
        StudyOptions options;
        options.draws = 4;
        options.has_load_cell = has_load_cell;
        options.mislead = fault.mislead;
        const StudyResult r = studyPooled(c, options);
        std::printf(" %5.1f %% %5.1f %% %4.0f %% |", 100.0 * meanOf(r.vessel_rms),
                    100.0 * r.vessel.band / r.vessel.mean, 100.0 * r.within_2);
        printStatus(r);
        nlohmann::json row = toJson(r);
        row["case"] = c.of.name;
        row["wrong"] = fault.what;
        row["load_cell"] = has_load_cell;
        rows.push_back(row);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  return rows;
}
}  // namespace
}  // namespace tether_monitor::bench

// bench_estimation FILE [CASES] [DRAWS] [TABLES]: p pooled, l late, c changing current, m misconfigured.
int main(int argc, char** argv)
{
  using namespace tether_monitor;
  if (argc < 2)
  {
    std::cerr << "usage: bench_estimation FILE [CASES] [DRAWS] [TABLES]\n";
    return 2;
  }
  const std::string cases = argc > 2 ? argv[2] : "CDIGRMS", tables = argc > 4 ? argv[4] : "plcm";
  nlohmann::json out;
  const int draws = argc > 3 ? std::atoi(argv[3]) : 32;
  // It takes an hour: what there is, is kept.
  const auto add = [&](char table, const char* name, const char* what, const std::function<nlohmann::json()>& rows)
  {
    if (tables.find(table) == std::string::npos)
      return;
    std::printf("%s\n", what);
    out[name] = rows();
    std::ofstream(argv[1]) << out.dump(1) << "\n";
  };
  add('p', "pooled", "truths that are drawn from what is told",
      [&] {
        return bench::pooled(bench::uncertainCases(), cases, {0.0, 1.0}, draws);
      });
  const std::vector<bench::UncertainCase> late{bench::uncertainCase("C"), bench::uncertainCase("D"),
                                               bench::uncertainCase("G")};
  add('l', "late", "positions that come ten seconds late",
      [&] { return bench::pooled(late, cases, {10.0}, draws); });
  add('c', "changing_current", "the current changes by 0.3 m/s; from five minutes after that on",
      [&] {
        return bench::pooled(bench::changingCurrents(), cases, {0.0, 1.0}, draws);
      });
  add('m', "misconfigured", "one thing configured wrong", [&] { return bench::misconfigured(cases); });
  return 0;
}
