#include "verification/estimation_study.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "verification/drawn_truths.h"

namespace tether_monitor::bench
{
namespace
{
using core::Vector3;

struct Sums
{
  long n = 0;
  double square = 0.0, mean = 0.0, band = 0.0, nees = 0.0, one = 0.0, two = 0.0, ninety = 0.0;

  void add(double estimate, double truth, double stddev, double p05, double p95)
  {
    const double error = estimate - truth;
    ++n;
    square += error * error;
    mean += truth;
    band += stddev;
    nees += error * error / (stddev * stddev);
    one += std::abs(error) <= stddev;
    two += std::abs(error) <= 2.0 * stddev;
    ninety += truth >= p05 && truth <= p95;
  }
  void add(const Sums& other)
  {
    n += other.n;
    square += other.square;
    mean += other.mean;
    band += other.band;
    nees += other.nees;
    one += other.one;
    two += other.two;
    ninety += other.ninety;
  }
  PooledScore score() const
  {
    const double count = std::max(1.0, static_cast<double>(n));
    return {n, std::sqrt(square / count), mean / count, band / count, nees / count, one / count, ninety / count};
  }
  double relative() const
  {
    return n > 0 ? std::sqrt(square / static_cast<double>(n)) / (mean / static_cast<double>(n)) : 0.0;
  }
};

constexpr double NOT_SURE = 1e9;

bool isSureAndWrong(const Truth& truth, const Trail& trail, std::size_t i)
{
  const double true_tension = truth.vessel_tension[trail.index[i]];
  const double error = std::abs(trail.vessel_tension[i] - true_tension);
  return trail.status[i] == monitor::Status::OK && error > 0.1 * true_tension &&
         error > 2.0 * trail.vessel_stddev[i];
}

// The sums of a study over its runs.
class Pool
{
 public:
  void add(const UncertainCase& c, const Truth& truth, const Trail& trail, int draws)
  {
    Sums vessel, vehicle;
    double sure_since = NOT_SURE;
    result_.limit_alarms += trail.limit_alarm;
    result_.hours += trail.t.back() / 3600.0;
    for (std::size_t i = 0; i < trail.t.size(); ++i)
    {
      if (trail.t[i] < c.of.count_from)
        continue;
      addStatus(trail, i);
      sure_since = isSureAndWrong(truth, trail, i) ? std::min(sure_since, trail.t[i]) : NOT_SURE;
      if (sure_since < NOT_SURE)
        result_.sure_and_wrong = std::max(result_.sure_and_wrong, trail.t[i] - sure_since);
      if (trail.status[i] == monitor::Status::INVALID)
        continue;
      valid_ += 1.0;
      const std::size_t at = trail.index[i];
      vessel.add(trail.vessel_tension[i], truth.vessel_tension[at], trail.vessel_stddev[i], trail.vessel_p05[i],
                 trail.vessel_p95[i]);
      vehicle.add(trail.vehicle_tension[i], truth.vehicle_tension[at], trail.vehicle_stddev[i],
                  trail.vehicle_p05[i], trail.vehicle_p95[i]);
      const double off = (trail.vehicle[i] - truth.vehicle[at].position).norm();
      square_ += off * off;
      within_ += off <= 2.0 * std::sqrt(3.0) * trail.vehicle_stddev_m[i];
    }
    vessel_.add(vessel);
    vehicle_.add(vehicle);
    result_.vessel_rms.push_back(vessel.relative());
    result_.vehicle_rms.push_back(vehicle.relative());
    result_.cpu += trail.cpu / (trail.t.back() * draws);
    ++result_.runs;
  }

  StudyResult result() const
  {
    StudyResult result = result_;
    result.vessel = vessel_.score();
    result.vehicle = vehicle_.score();
    result.within_2 = vessel_.two / std::max(1.0, static_cast<double>(vessel_.n));
    result.position_rms = std::sqrt(square_ / std::max(valid_, 1.0));
    result.position_within_2 = within_ / std::max(valid_, 1.0);
    const double total = std::max(total_, 1.0);
    result.ok /= total;
    result.implausible /= total;
    result.disagreement /= total;
    result.valid = valid_ / total;
    return result;
  }

 private:
  void addStatus(const Trail& trail, std::size_t i)
  {
    total_ += 1.0;
    result_.ok += trail.status[i] == monitor::Status::OK;
    result_.implausible += trail.reason[i] == monitor::Reason::IMPLAUSIBLE;
    result_.disagreement += trail.reason[i] == monitor::Reason::DISAGREEMENT;
  }

  StudyResult result_;
  Sums vessel_, vehicle_;
  double square_ = 0.0, within_ = 0.0, valid_ = 0.0, total_ = 0.0;
};

// The measurements of a truth and what the estimator is told of it.
Trail observeDraw(const StudyOptions& options, const DrawnTruth& drawn)
{
  Sensors sensors;
  sensors.seed = drawn.seed + 77;
  sensors.latency = options.latency;
  sensors.has_load_cell = options.has_load_cell;
  monitor::Config config = configFor(drawn.of, drawn.truth, sensors);
  sensors.tension_bias = tensionBias(drawn, config);
  sensors.tension_stddev = config.uncertainty.tension_stddev;
  config.elements = options.elements;
  config.rate = options.rate;
  config.solver.step = 1.0 / options.rate;
  if (options.mislead)
    options.mislead(config);
  return observe(drawn.truth, config, sensors);
}
}  // namespace

StudyResult studyPooled(const UncertainCase& c, const StudyOptions& options)
{
  Pool pool;
  std::mutex mutex;
  forEachTruth([&](unsigned) { return c; }, options.draws, options.first_seed, options.threads,
               static_cast<bool>(options.mislead),
               [&](const DrawnTruth& drawn)
               {
                 const Trail trail = observeDraw(options, drawn);
                 const std::lock_guard<std::mutex> lock(mutex);
                 pool.add(c, drawn.truth, trail, options.draws);
               });
  return pool.result();
}

std::vector<Misconfiguration> misconfigurations()
{
  const auto current = [](double x, double y)
  { return [x, y](monitor::Config& c) { c.environment.current = core::CurrentProfile(Vector3(-x, -y, 0.0)); }; };
  const auto weakVehicle = [](monitor::Config& c)
  {
    c.vehicle_body.drag_area *= 1.3;
    c.vehicle_body.force += Vector3(-800.0, 600.0, 0.0);
  };
  return {{"nothing", [](monitor::Config&) {}},
          {"drag_normal -26 %", [](monitor::Config& c) { c.tether.drag_normal *= 0.74; }},
          {"drag_normal +33 %", [](monitor::Config& c) { c.tether.drag_normal *= 1.33; }},
          {"mass +5 %", [](monitor::Config& c) { c.tether.mass_per_length *= 1.05; }},
          {"current 0.3 m/s along", current(0.3, 0.0)},
          {"current 0.3 m/s across", current(0.0, 0.3)},
          {"length +1 %", [](monitor::Config& c) { c.tether.length *= 1.01; }},
          {"length -1 %", [](monitor::Config& c) { c.tether.length *= 0.99; }},
          {"vehicle's drag x 1.3, 1000 N", weakVehicle},
          {"drag -26 %, mass +3 %, current, vehicle", [=](monitor::Config& c)
           {
             c.tether.drag_normal *= 0.74;
             c.tether.mass_per_length *= 1.03;
             current(0.2, 0.2)(c);
             weakVehicle(c);
           }}};
}

}  // namespace tether_monitor::bench
