#include "verification/forecast_study.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <random>
#include <stdexcept>
#include <thread>

#include "tether_monitor/monitor/forecast/tether_forecaster.h"

namespace tether_monitor::bench
{
namespace
{
using core::EndMotion;
using core::Vector3;

constexpr double BEGIN = 45.0, DURATION = 150.0;  // [s]
constexpr double SEEN = 5.0;                      // [s] after which a change can have been seen
constexpr double SETTLED = 10.0;                  // [s]
constexpr double LEAST_SHARE = 0.3, MOST_SHARE = 0.8, LEAST_RISE = 1.1;  // of the change of the tension
constexpr int MEMBERS = 96, THREADS = 2;
constexpr double HORIZON = 30.0, PERIOD = 1.0;  // [s]

// Integral of a speed that goes from one value to another within `ramp` seconds from BEGIN on.
double distanceAt(double t, double from, double to, double ramp)
{
  const double since = std::clamp(t - BEGIN, 0.0, ramp);
  return from * t + (to - from) * (0.5 * since * since / ramp + std::max(t - BEGIN - ramp, 0.0));
}

ForecastCase tow(const std::string& what, double from, double to, double heave_later)
{
  ForecastCase c{uncertainCase("C")};
  c.of.true_elements = 50;
  c.of.of.what = what;
  c.of.of.duration = DURATION;
  c.of.of.start.velocity = {from, 0.0, 0.0};
  c.of.of.vessel = [=](double t)
  {
    constexpr double W = 2.0 * M_PI / 8.0, HEAVE = 0.4, GROWS = 40.0;
    const double height = HEAVE + (heave_later - HEAVE) * std::clamp((t - BEGIN) / GROWS, 0.0, 1.0);
    return EndMotion{
        {distanceAt(t, from, to, 40.0), 0.0, -5.0 + std::min(t / 16.0, 1.0) * height * std::sin(W * t)},
        Vector3::Zero()};
  };
  return c;
}

ForecastCase vehicle(const std::string& what, double vehicle_speed, double vessel_speed)
{
  ForecastCase c{uncertainCase("G")};
  c.of.reports_thrust = true;
  c.of.force_stddev = 40.0;
  c.of.of.what = what;
  c.of.of.duration = DURATION;
  c.of.changes_at = BEGIN;
  c.of.most_thrust = 900.0;
  c.of.run_off = {vehicle_speed, 0.0, 0.0};
  const auto drifting = c.of.of.vessel;
  c.of.of.vessel = [=](double t)
  {
    EndMotion end = drifting(t);
    end.position.x() -= distanceAt(t, 0.0, vessel_speed, 10.0);
    return end;
  };
  return c;
}
double tensionAt(const Truth& truth, std::size_t i)
{
  return std::max(truth.vessel_tension[i], truth.vehicle_tension[i]);
}

// A limit between the largest tension before the change and that after it: an event in nearly every truth, at
// another distance in each. Zero: the change adds too little.
double limitFor(const Truth& truth, unsigned seed)
{
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < truth.vessel_tension.size(); ++i)
  {
    const double t = truth.timeOf(i);
    double& most = t < BEGIN ? before : after;
    if (t > SETTLED)
      most = std::max(most, tensionAt(truth, i));
  }
  std::mt19937 generator(seed + 991);
  const double share = std::uniform_real_distribution<double>(LEAST_SHARE, MOST_SHARE)(generator);
  return after > LEAST_RISE * before ? before + share * (after - before) : 0.0;
}
}  // namespace

std::vector<ForecastCase> forecastCases()
{
  return {tow("a tow speeds up from 2 to 3.2 m/s", 2.0, 3.2, 0.4),
          tow("the heave of a tow grows from 0.4 to 2.5 m", 2.5, 2.5, 2.5),
          vehicle("a vehicle runs off at 0.8 m/s", 0.8, 0.0), vehicle("the vessel sets off at 0.8 m/s", 0.0, 0.8)};
}

ForecastStudy studyForecasts(const ForecastCase& c, int draws, unsigned first_seed, bool has_load_cell,
                             monitor::ForecastScore& total)
{
  ForecastStudy study;
  monitor::ForecastScore pooled;
  long forecasts = 0;
  std::atomic<int> next{0};
  std::mutex mutex;
  const auto work = [&]
  {
    for (int k = next++; k < draws; k = next++)
    {
      const unsigned seed = first_seed + static_cast<unsigned>(k);
      const TruthDraw draw = drawTruth(c.of, seed);
      Truth truth;
      try
      {
        truth = makeTruth(c.of, draw);
      }
      catch (const std::runtime_error&)
      {
        continue;  // no steady state, or too taut to go on
      }
      Sensors sensors;
      sensors.seed = seed + 77;
      sensors.has_load_cell = has_load_cell;
      monitor::Config config = configFor(c.of, truth, sensors);
      const double limit = limitFor(truth, seed);
      if (limit == 0.0)
        continue;
      config.tether.working_load = limit;
      config.tether.breaking_load = 10.0 * limit;
      config.rate = 10.0;
      config.solver.step = 0.1;
      sensors.tension_bias = draw.tension_bias * config.uncertainty.tension_bias * limit;
      monitor::TetherForecaster forecaster(config);
      monitor::ForecastScore score;
      double last = -PERIOD, cpu = 0.0;
      long made = 0;
      observe(truth, config, sensors,
              [&](const monitor::TetherEstimator& estimator, std::size_t i)
              {
                const double t = truth.timeOf(i);
                score.observe(t, tensionAt(truth, i) > limit);
                const auto start = t >= last + PERIOD - 1e-6 ? estimator.forecastStart() : std::nullopt;
                if (!start || (t > BEGIN - HORIZON && t < BEGIN + SEEN))
                  return;
                last = t;
                const double began = cpuTime();
                score.add(forecaster.run(*start, HORIZON, MEMBERS));
                cpu += cpuTime() - began;
                ++made;
              });
      const std::lock_guard<std::mutex> lock(mutex);
      pooled.add(score);
      total.add(score);
      study.cpu += cpu;
      forecasts += made;
      ++study.runs;
    }
  };
  std::vector<std::thread> threads;
  for (int k = 1; k < THREADS; ++k)
    threads.emplace_back(work);
  work();
  for (std::thread& thread : threads)
    thread.join();
  study.cpu /= static_cast<double>(std::max(forecasts, 1L));
  study.result = pooled.result();
  return study;
}

}  // namespace tether_monitor::bench
