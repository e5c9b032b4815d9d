#include "tether_monitor/replay/forecast_recorder.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tether_monitor/replay/cpu_clock.h"

namespace tether_monitor::replay
{
namespace
{
constexpr double USUAL_RATE = 1.0;  // [Hz], where the node makes none
}

ForecastRecorder::ForecastRecorder(const std::string& folder, const monitor::Config& config)
  : config_(config.forecast),
    limits_(config),
    forecaster_(config),
    file_(folder + "/forecast.csv",
          "t,horizon,members,probability_over_tension,probability_breaking,probability_slack,time_to_warning,"
          "time_to_limit,time_to_limit_p05,time_to_slack,place_s,max_tension,max_tension_p05,max_tension_p95")
{
  if (!(config_.rate > 0.0))
    config_.rate = USUAL_RATE;
}

void ForecastRecorder::observe(const monitor::TetherEstimator& estimator)
{
  const monitor::TetherEstimate& e = estimator.estimate();
  if (!e.has_stations)
    return;
  const bool is_over = limits_.limit && e.working_utilisation > *limits_.limit;
  score_.observe(e.time, is_over);
  if (e.time < last_ + 1.0 / config_.rate - 1e-6 && e.time >= last_)
    return;
  const std::optional<monitor::ForecastStart> start = estimator.forecastStart();
  if (!start)
    return;
  last_ = e.time;
  const double began = cpuClock();
  const monitor::TetherForecast forecast = forecaster_.run(*start, config_.horizon, config_.members);
  cpu_seconds_ += cpuClock() - began;
  ++count_;
  score_.add(forecast, is_over);
  write(forecast);
}

// The largest of each curve: what a forecast comes to.
void ForecastRecorder::write(const monitor::TetherForecast& f)
{
  const auto largest = [](const std::vector<double>& curve)
  { return curve.empty() ? monitor::TetherForecast::NONE : *std::max_element(curve.begin(), curve.end()); };
  file_.time(f.t).number(f.horizon).number(f.members);
  for (const double x : {f.probability_over_tension, f.probability_breaking, f.probability_slack,
                         f.time_to_warning, f.time_to_limit, f.time_to_limit_p05, f.time_to_slack, f.place_s,
                         largest(f.max_tension), largest(f.max_tension_p05), largest(f.max_tension_p95)})
    file_.number(x);
  file_.endRow();
}

nlohmann::json ForecastRecorder::score() const
{
  const monitor::ForecastScore::Result r = score_.result();
  nlohmann::json out{
      {"forecasts", count_}, {"cpu_seconds", cpu_seconds_}, {"brier_score", r.brier_score}, {"events", r.events}};
  for (const monitor::ForecastScore::Warnings& w : r.warnings)
    out["warnings"].push_back({{"from_probability", w.probability},
                               {"warned_10_s_ahead", w.warned},
                               {"median_lead_time", w.median_lead_time},
                               {"warnings", w.warnings},
                               {"false_warnings", w.false_warnings}});
  out["reliability"] = nlohmann::json::array();
  for (const monitor::ForecastScore::Reliability& row : r.reliability)
    out["reliability"].push_back({{"from", row.least},
                                  {"to", row.most},
                                  {"forecasts", row.forecasts},
                                  {"mean_probability", row.mean_probability},
                                  {"came_true", row.observed}});
  return out;
}

}  // namespace tether_monitor::replay
