#include "tether_monitor/replay/result_recorder.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "tether_monitor/replay/cpu_clock.h"

namespace tether_monitor::replay
{
namespace
{
constexpr double PARAMETER_PERIOD = 1.0;  // [s]
constexpr double EARLIEST = 1e8;          // [s since 1970]; before it a clock is a simulated one
constexpr monitor::Status ALL_STATUSES[] = {monitor::Status::OK, monitor::Status::DEGRADED,
                                            monitor::Status::INVALID, monitor::Status::STOWED};

std::string prepared(const std::string& folder)
{
  files::makeFolder(folder);
  return folder;
}

// "OK 98.8 %"
std::string percentage(const std::string& what, long count, long all)
{
  std::ostringstream text;
  text << what << " " << std::fixed << std::setprecision(1)
       << 100.0 * static_cast<double>(count) / static_cast<double>(all) << " %";
  return text.str();
}

nlohmann::json orNull(double value)
{
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json(nullptr);
}
}  // namespace

ResultRecorder::ResultRecorder(const std::string& folder, double shape_rate, VehicleColumns vehicle)
  : folder_(prepared(folder)), lock_(folder), shape_rate_(shape_rate), vehicle_(vehicle)
{
}

void ResultRecorder::addForecasts(const monitor::Config& config)
{
  forecast_config_ = config;
}

void ResultRecorder::open()
{
  if (ends_)
    return;
  ends_ = std::make_unique<EndsFile>(folder_, vehicle_);
  alarms_ = std::make_unique<AlarmsFile>(folder_);
  if (shape_rate_ > 0.0)
    shape_ = std::make_unique<ShapeFile>(folder_);
  if (vehicle_ == VehicleColumns::OBSERVED)
    parameters_ = std::make_unique<ParametersFile>(folder_);
  if (forecast_config_)
    forecasts_ = std::make_unique<ForecastRecorder>(folder_, *forecast_config_);
}

void ResultRecorder::startTimer()
{
  step_began_ = cpuClock();
}

void ResultRecorder::stopTimer()
{
  const double used = cpuClock() - step_began_;
  cpu_seconds_ += used;
  worst_step_ = std::max(worst_step_, used);
}

void ResultRecorder::accumulate(const monitor::TetherEstimator& estimator)
{
  open();
  const monitor::TetherEstimate& e = estimator.estimate();
  if (std::isnan(first_time_))
    first_time_ = e.time;
  last_time_ = e.time;
  if (e.has_stations && !(e.max_tension <= max_tension_))
  {
    max_tension_ = e.max_tension;
    max_tension_t_ = e.time;
    max_tension_s_ = e.max_tension_s;
  }
  alarms_->write(e.time, estimator.alarms());
  if (forecasts_)
    forecasts_->observe(estimator);
}

void ResultRecorder::writeRow(const monitor::TetherEstimator& estimator)
{
  open();
  const monitor::TetherEstimate& e = estimator.estimate();
  ends_->write(e);
  ++status_count_[static_cast<int>(e.status)];
  if (e.reason != monitor::Reason::NONE)
    ++reason_count_[describe(e.reason)];
  if (parameters_ && e.has_stations && e.time >= next_parameters_ - 1e-9)
  {
    parameters_->write(e.time, estimator.parameters());
    next_parameters_ = e.time + PARAMETER_PERIOD;
  }
  const std::vector<core::Obstacle>& obstacles = estimator.simulation().model.environment().obstacles();
  if (!contacts_ && !obstacles.empty())
    contacts_ = std::make_unique<ContactsFile>(folder_);
  if (contacts_)
    contacts_->write(e, obstacles);
  if (shape_ && e.has_stations && e.time >= next_shape_ - 1e-9)
  {
    shape_->write(e);
    next_shape_ = std::max(std::isfinite(next_shape_) ? next_shape_ : e.time, e.time - 1.0 / shape_rate_) +
                  1.0 / shape_rate_;
  }
}

void ResultRecorder::finish(const monitor::TetherEstimator& estimator, bool interrupted)
{
  open();
  nlohmann::json summary;
  if (interrupted)
    summary["interrupted"] = true;
  if (epoch_ && *epoch_ > EARLIEST)
    summary["epoch"] = *epoch_;
  summary["simulated_seconds"] = orNull(last_time_ - first_time_);
  summary["cpu_seconds"] = cpu_seconds_;
  summary["working_load"] = estimator.config().tether.working_load;
  summary["breaking_load"] = estimator.config().tether.breaking_load;
  summary["elements"] = estimator.simulation().model.elements();
  summary["largest_step"] = estimator.simulation().mesh.step;
  summary["expected_error"] = orNull(estimator.simulation().mesh.error);
  summary["steps"] = estimator.simulation().count.steps;
  summary["iterations"] = estimator.simulation().count.iterations;
  summary["rejected_steps"] = estimator.simulation().count.rejected;
  summary["worst_step_us"] = 1e6 * worst_step_;
  summary["max_tension"] = orNull(max_tension_);
  summary["max_tension_t"] = orNull(max_tension_t_);
  summary["max_tension_s"] = orNull(max_tension_s_);
  for (const monitor::Status status : ALL_STATUSES)
    summary["status"][describe(status)] = status_count_[static_cast<int>(status)];
  summary["reason"] = nlohmann::json::object();
  for (const auto& [reason, count] : reason_count_)
    summary["reason"][reason] = count;
  if (forecasts_)
    summary["forecast"] = forecasts_->score();
  std::ofstream out(folder_ + "/summary.json");
  out << summary.dump(2) << "\n";
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + folder_ + "/summary.json");
  ends_->close();
  alarms_->close();
  if (shape_)
    shape_->close();
  if (contacts_)
    contacts_->close();
  if (parameters_)
    parameters_->close();
  if (forecasts_)
    forecasts_->close();
  if (!inputs_.empty())
    inputs_.write(folder_);
}

std::vector<std::string> ResultRecorder::files() const
{
  std::vector<std::string> names{"summary.json", "ends.csv", "alarms.csv"};
  for (const auto& [is_there, name] : {std::pair<bool, const char*>{shape_ != nullptr, "shape.csv"},
                                       {parameters_ != nullptr, "parameters.csv"},
                                       {contacts_ != nullptr, "contacts.csv"},
                                       {forecasts_ != nullptr, "forecast.csv"},
                                       {!inputs_.empty(), "inputs.csv"}})
    if (is_there)
      names.emplace_back(name);
  return names;
}

double ResultRecorder::shareOf(monitor::Status status) const
{
  const long rows = std::accumulate(status_count_.begin(), status_count_.end(), 0L);
  return rows > 0 ? static_cast<double>(status_count_[static_cast<int>(status)]) / static_cast<double>(rows) : 0.0;
}

std::string ResultRecorder::statusText() const
{
  const long rows = std::accumulate(status_count_.begin(), status_count_.end(), 0L);
  std::string text;
  for (const monitor::Status status : ALL_STATUSES)
    if (const long count = status_count_[static_cast<int>(status)])
      text += (text.empty() ? "" : ", ") + percentage(describe(status), count, rows);
  std::vector<std::pair<long, std::string>> reasons;
  for (const auto& [reason, count] : reason_count_)
    reasons.emplace_back(count, reason);
  std::sort(reasons.rbegin(), reasons.rend());
  std::string why;
  for (const auto& [count, reason] : reasons)
    why += (why.empty() ? " (" : ", ") + percentage(reason, count, rows);
  return text + why + (why.empty() ? "" : ")");
}

}  // namespace tether_monitor::replay
