#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "tether_monitor/files/csv_writer.h"
#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/monitor/forecast/forecast_score.h"
#include "tether_monitor/monitor/forecast/tether_forecaster.h"

namespace tether_monitor::replay
{
/// Makes forecasts during a replay, as the node does, writes forecast.csv and scores them against what comes.
class ForecastRecorder
{
 public:
  ForecastRecorder(const std::string& folder, const monitor::Config& config);

  /// After a step of the estimator.
  void observe(const monitor::TetherEstimator& estimator);
  /// What summary.json says of them.
  nlohmann::json score() const;
  void close() { file_.close(); }

 private:
  void write(const monitor::TetherForecast& forecast);

  monitor::ForecastConfig config_;
  monitor::ForecastLimits limits_;
  monitor::TetherForecaster forecaster_;
  monitor::ForecastScore score_;
  files::CsvWriter file_;
  double last_ = -1e300;      // [s]
  double cpu_seconds_ = 0.0;  // of forecasting
  long count_ = 0;
};

}  // namespace tether_monitor::replay
