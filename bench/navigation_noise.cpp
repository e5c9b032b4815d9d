// How well the vessel tension is known under navigation noise: cases C, D and G, vehicle known and wrong, the
// observed vehicle beside what else could be done. Prints a table; writes results.json and trails for the plot.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

#include "verification/navigation_study.h"

namespace tether_monitor::bench
{
namespace
{
using monitor::ObserverGains;
using monitor::VehicleMode;

struct Trial
{
  const char* name;
  double drag_factor;
};

struct Estimator
{
  const char* name;
  VehicleMode mode;
  ObserverGains gains;
  double outliers = 0.05;

  bool isOurs() const { return mode == VehicleMode::OBSERVED && gains == ObserverGains::KALMAN; }
  bool hasBand() const { return mode == VehicleMode::OBSERVED && gains != ObserverGains::FIXED; }
};

constexpr Trial TRIALS[] = {{"known", 1.0}, {"wrong", 1.3}};
constexpr Estimator ESTIMATORS[] = {{"observed", VehicleMode::OBSERVED, ObserverGains::KALMAN},
                                    {"without tether", VehicleMode::OBSERVED, ObserverGains::NO_TETHER_MODEL},
                                    {"fixed gains", VehicleMode::OBSERVED, ObserverGains::FIXED},
                                    {"held end", VehicleMode::TRACKED, ObserverGains::KALMAN},
                                    {"held, no outliers", VehicleMode::TRACKED, ObserverGains::KALMAN, 0.0}};

// Mean over seeds; the worst of them where it says so.
struct Sum
{
  double square = 0.0, worst = 0.0, peak = 0.0, one = 0.0, two = 0.0, stddev = 0.0, ok = 0.0;
  int alarms = 0, runs = 0;

  void add(const Score& s, const Trail& trail)
  {
    square += s.rms * s.rms;
    worst = std::max(worst, s.rms);
    peak = std::abs(s.peak) > std::abs(peak) ? s.peak : peak;
    one += s.within_1;
    two += s.within_2;
    stddev += s.mean_stddev;
    ok += s.ok;
    alarms += trail.limit_alarm;
    ++runs;
  }
  double rms() const { return std::sqrt(square / runs); }
};

// Of the wrong vehicle: in D and G a force from ahead and aside; in C the thousand newtons that it has are not
// reported.
core::Vector3 untoldForce(const std::string& name)
{
  const double size = name == "G" ? 100.0 : name == "D" ? 1000.0 : 0.0;
  return size * core::Vector3(-0.8, 0.6, 0.0);
}

void writeTrail(const std::string& path, const Truth& truth, const Trail& trail)
{
  std::ofstream out(path);
  out << "t,truth,tension,stddev\n";
  for (std::size_t i = 0; i < trail.t.size(); i += 4)
    out << trail.t[i] << "," << truth.vessel_tension[i] << "," << trail.vessel_tension[i] << ","
        << trail.vessel_stddev[i] << "\n";
}

class Study
{
 public:
  Study(std::string folder, int seeds, double duration)
    : folder_(std::move(folder)), seeds_(seeds), duration_(duration)
  {
  }

  void run()
  {
    std::printf("%-4s %-6s %-17s %8s %8s %8s %7s %6s %6s %7s %7s\n", "case", "", "estimator", "rms %", "worst %",
                "peak %", "sd %", "in 1s", "in 2s", "OK", "alarms");
    for (const Case& c : navigationCases())
      for (const Trial& trial : TRIALS)
      {
        const bool is_wrong = trial.drag_factor != 1.0;
        const Truth truth = makeTruth(c, duration_, is_wrong ? untoldForce(c.name) : core::Vector3::Zero());
        for (const Estimator& estimator : ESTIMATORS)
          report(c, trial, estimator, runs(truth, trial, estimator));
      }
    const double n = ours_.runs;
    std::printf("coverage of all observed runs: %.0f %% within one, %.0f %% within two standard deviations\n",
                100.0 * ours_.one / n, 100.0 * ours_.two / n);
    std::printf("CPU of a cycle over that of a plain one (mode free): %.2f\n", cpu_ / free_cpu_);
    const nlohmann::json all = {{"seeds", seeds_},
                                {"duration", duration_},
                                {"within_1", ours_.one / n},
                                {"within_2", ours_.two / n},
                                {"cpu_over_plain", cpu_ / free_cpu_},
                                {"rows", rows_}};
    std::ofstream(folder_ + "/navigation_noise.json") << all.dump(1) << "\n";
  }

 private:
  Sum runs(const Truth& truth, const Trial& trial, const Estimator& estimator)
  {
    Sum sum;
    for (int seed = 1; seed <= seeds_; ++seed)
    {
      Sensors sensors;
      sensors.seed = static_cast<unsigned>(seed);
      Knowledge knowledge;
      sensors.outliers = estimator.outliers;
      knowledge.drag_factor = trial.drag_factor;
      knowledge.gains = estimator.gains;
      monitor::Config config = configFor(truth, knowledge, estimator.mode, sensors);
      if (trial.drag_factor != 1.0 && truth.of.name == "C")
        config.vehicle_body.force.setZero();
      const Trail trail = observe(truth, config, sensors);
      const Score s = score(truth, trail);
      sum.add(s, trail);
      if (seed == 1 && (estimator.isOurs() || estimator.outliers == 0.0))
        writeTrail(folder_ + "/" + truth.of.name + "_" + trial.name +
                       (estimator.isOurs() ? "_observed.csv" : "_held.csv"),
                   truth, trail);
      if (!estimator.isOurs())
        continue;
      ours_.add(s, trail);
      // Beside it a simulated vehicle under a vessel whose motion is known.
      config.vehicle_mode = VehicleMode::FREE;
      sensors.satellite_interval = truth.step;
      sensors.satellite_stddev = 0.0;
      cpu_ += trail.cpu;
      free_cpu_ += observe(truth, config, sensors).cpu;
    }
    return sum;
  }

  void report(const Case& c, const Trial& trial, const Estimator& estimator, const Sum& sum)
  {
    const double n = sum.runs;
    std::printf("%-4s %-6s %-17s %8.2f %8.2f %+8.1f", c.name.c_str(), trial.name, estimator.name,
                100.0 * sum.rms(), 100.0 * sum.worst, 100.0 * sum.peak);
    estimator.hasBand()
        ? std::printf(" %7.2f %6.0f %6.0f", 100.0 * sum.stddev / n, 100.0 * sum.one / n, 100.0 * sum.two / n)
        : std::printf(" %7s %6s %6s", "-", "-", "-");
    std::printf(" %7.2f %4d/%d\n", sum.ok / n, sum.alarms, sum.runs);
    nlohmann::json row = {{"case", c.name},   {"vehicle", trial.name},      {"estimator", estimator.name},
                          {"rms", sum.rms()}, {"worst_rms", sum.worst},     {"peak", sum.peak},
                          {"ok", sum.ok / n}, {"limit_alarms", sum.alarms}, {"runs", sum.runs}};
    if (estimator.hasBand())
      row.update({{"stddev", sum.stddev / n}, {"within_1", sum.one / n}, {"within_2", sum.two / n}});
    rows_.push_back(row);
  }

  std::string folder_;
  int seeds_;
  double duration_;
  nlohmann::json rows_ = nlohmann::json::array();
  Sum ours_;
  double cpu_ = 0.0, free_cpu_ = 0.0;
};
}  // namespace
}  // namespace tether_monitor::bench

int main(int argc, char** argv)
{
  if (argc < 2 || argc > 4)
  {
    std::cerr << "usage: bench_navigation_noise FOLDER [SEEDS [SECONDS]]  (SECONDS 0: the cases' own)\n";
    return 1;
  }
  try
  {
    tether_monitor::bench::Study(argv[1], argc > 2 ? std::stoi(argv[2]) : 8, argc > 3 ? std::stod(argv[3]) : 0.0)
        .run();
  }
  catch (const std::exception& error)
  {
    std::cerr << "bench_navigation_noise: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
