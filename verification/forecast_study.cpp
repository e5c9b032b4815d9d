#include "verification/forecast_study.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "tether_monitor/monitor/forecast/tether_forecaster.h"
#include "verification/drawn_truths.h"

namespace tether_monitor::bench
{
namespace
{
constexpr double SEEN = 5.0;  // [s] after which a manoeuvre can have been seen
constexpr double SETTLED = MANOEUVRE_BEGINS - 17.0, FIRST_SCORED = 25.0;  // [s]
constexpr int MEMBERS = 64, THREADS = 2;
constexpr double HORIZON = 30.0, PERIOD = 2.0;  // [s]

double tensionAt(const Truth& truth, std::size_t i)
{
  return std::max(truth.vessel_tension[i], truth.vehicle_tension[i]);
}

// Evenly on a logarithmic scale, over the largest tension of a tether that is as told: what is known before the
// dive.
double limitFor(const Manoeuvre& manoeuvre, const DrawnTruth& drawn)
{
  const Truth told = makeTruth(drawn.of, TruthDraw());
  double before = 0.0;
  for (std::size_t i = 0; i < told.vessel_tension.size(); ++i)
    if (const double t = told.timeOf(i); t > SETTLED && t < MANOEUVRE_BEGINS)
      before = std::max(before, tensionAt(told, i));
  std::mt19937 generator(drawn.seed + 991);
  const double share = std::uniform_real_distribution<double>()(generator);
  return before * std::pow(manoeuvre.most_margin, share);
}

// Whether what is forecast at that time is not for somebody to decide yet.
bool isScored(double t)
{
  return t > FIRST_SCORED && (t < MANOEUVRE_BEGINS - HORIZON || t > MANOEUVRE_BEGINS + SEEN);
}

struct ScoredDive
{
  monitor::ForecastScore score;
  long forecasts = 0;
  double cpu = 0.0;  // [s]
};

ScoredDive scoreDive(const Manoeuvre& manoeuvre, const DrawnTruth& drawn, bool has_load_cell)
{
  Sensors sensors;
  sensors.seed = drawn.seed + 77;
  sensors.has_load_cell = has_load_cell;
  monitor::Config config = configFor(drawn.of, drawn.truth, sensors);
  const double limit = limitFor(manoeuvre, drawn);
  config.tether.working_load = limit;
  config.tether.breaking_load = 10.0 * limit;
  config.rate = 10.0;
  config.solver.step = 0.1;
  sensors.tension_bias = tensionBias(drawn, config);
  monitor::TetherForecaster forecaster(config);
  ScoredDive dive;
  double last = -PERIOD;
  observe(drawn.truth, config, sensors,
          [&](const monitor::TetherEstimator& estimator, std::size_t i)
          {
            const double t = drawn.truth.timeOf(i);
            dive.score.observe(t, tensionAt(drawn.truth, i) > limit);
            if (t < last + PERIOD - 1e-6 || !isScored(t))
              return;
            const auto start = estimator.forecastStart();
            if (!start)
              return;
            last = t;
            const double began = cpuTime();
            dive.score.add(forecaster.run(*start, HORIZON, MEMBERS),
                           estimator.estimate().working_utilisation > 1.0);
            dive.cpu += cpuTime() - began;
            ++dive.forecasts;
          });
  return dive;
}
}  // namespace

ForecastStudy studyForecasts(const Manoeuvre& manoeuvre, int draws, unsigned first_seed, bool has_load_cell,
                             monitor::ForecastScore& total)
{
  ForecastStudy study;
  monitor::ForecastScore pooled;
  long forecasts = 0;
  std::mutex mutex;
  const auto caseOf = [&](unsigned seed)
  {
    std::mt19937 generator(seed + 4711);
    return manoeuvre.draw(generator);
  };
  forEachTruth(caseOf, draws, first_seed, THREADS, false,
               [&](const DrawnTruth& drawn)
               {
                 const ScoredDive dive = scoreDive(manoeuvre, drawn, has_load_cell);
                 const std::lock_guard<std::mutex> lock(mutex);
                 pooled.add(dive.score);
                 total.add(dive.score);
                 study.cpu += dive.cpu;
                 forecasts += dive.forecasts;
                 ++study.runs;
               });
  study.cpu /= static_cast<double>(std::max(forecasts, 1L));
  study.result = pooled.result();
  return study;
}

}  // namespace tether_monitor::bench
