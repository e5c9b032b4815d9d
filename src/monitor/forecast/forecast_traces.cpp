#include "tether_monitor/monitor/forecast/forecast_traces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tether_monitor/monitor/alarms/alarm_quantities.h"
#include "tether_monitor/monitor/ensemble/member_statistics.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double NEVER = std::numeric_limits<double>::infinity();

// Those of the members that are left, in order of size.
class Sorted
{
 public:
  template <class Values, class Alive>
  Sorted(const Values& values, const Alive& alive)
  {
    for (Eigen::Index i = 0; i < alive.size(); ++i)
      if (alive[i])
        sorted_.push_back(values[i]);
    std::sort(sorted_.begin(), sorted_.end());
  }
  double quantile(double share) const
  {
    return monitor::quantile(
        Eigen::Map<const Eigen::RowVectorXd>(sorted_.data(), static_cast<Eigen::Index>(sorted_.size())), share);
  }
  /// The time by which a share of all gets there; NaN if fewer do.
  double timeOf(double share) const
  {
    const auto k = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted_.size()))) - 1;
    return sorted_[k] < NEVER ? sorted_[k] : TetherForecast::NONE;
  }
  /// Median of those that get there, if half of them do.
  double medianOfThoseThatDo() const
  {
    const auto count = static_cast<std::size_t>(
        std::count_if(sorted_.begin(), sorted_.end(), [](double t) { return t < NEVER; }));
    return 2 * count >= sorted_.size() && count > 0 ? sorted_[(count - 1) / 2] : TetherForecast::NONE;
  }
  double shareThatDo() const
  {
    const auto count = std::count_if(sorted_.begin(), sorted_.end(), [](double t) { return t < NEVER; });
    return static_cast<double>(count) / static_cast<double>(sorted_.size());
  }

 private:
  std::vector<double> sorted_;
};
}  // namespace

ForecastLimits::ForecastLimits(const Config& config)
{
  const AlarmConfig over = alarmConfig(config, alarmQuantity(OVER_TENSION));
  warning = over.warning;
  limit = over.limit;
  breaking = alarmConfig(config, alarmQuantity(BREAKING)).limit;
  slack = alarmConfig(config, alarmQuantity("slack")).limit.value_or(0.0);
}

void ForecastTraces::begin(int members, double horizon, double interval)
{
  horizon_ = horizon;
  interval_ = interval;
  const auto times = static_cast<Eigen::Index>(std::floor(horizon / interval + 1e-9));
  largest_ = Table::Constant(times, members, -NEVER);
  least_ = Table::Constant(times, members, NEVER);
  vessel_ = vehicle_ = Table::Zero(times, members);
  alive_.setConstant(members, true);
  breaks_.setConstant(members, false);
  to_warning_ = to_limit_ = to_slack_ = Row::Constant(members, NEVER);
  peak_ = Row::Constant(members, -NEVER);
  place_ = Row::Zero(members);
  last_.assign(static_cast<std::size_t>(members), {});
}

void ForecastTraces::add(int member, double after, const TetherEstimate& e, const ForecastLimits& limits)
{
  const auto row = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::ceil(after / interval_ - 1e-6)) - 1, 0,
                                            largest_.rows() - 1);
  largest_(row, member) = std::max(largest_(row, member), e.max_tension);
  least_(row, member) = std::min(least_(row, member), e.min_tension);
  vessel_(row, member) = e.vessel_tension;
  vehicle_(row, member) = e.vehicle_tension;
  const auto note = [&](bool is_there, double& first)
  {
    if (is_there)
      first = std::min(first, after);
  };
  note(limits.warning && e.working_utilisation > *limits.warning, to_warning_[member]);
  note(limits.limit && e.working_utilisation > *limits.limit, to_limit_[member]);
  note(e.min_tension < limits.slack, to_slack_[member]);
  breaks_[member] = breaks_[member] || (limits.breaking && e.breaking_utilisation > *limits.breaking);
  if (e.max_tension <= peak_[member])
    return;
  peak_[member] = e.max_tension;
  place_[member] = e.max_tension_s;
}

double ForecastTraces::probabilityOfOverTension() const
{
  return Sorted(to_limit_, alive_).shareThatDo();
}

void ForecastTraces::summarize(TetherForecast& f) const
{
  f.horizon = horizon_;
  f.members = alive();
  const auto times = static_cast<std::size_t>(largest_.rows());
  for (std::vector<double>* curve : {&f.time, &f.max_tension, &f.max_tension_p05, &f.max_tension_p95,
                                     &f.vessel_tension, &f.vehicle_tension, &f.min_tension})
    curve->resize(times);
  for (std::size_t k = 0; k < times; ++k)
  {
    const auto row = static_cast<Eigen::Index>(k);
    const Sorted largest(largest_.row(row), alive_);
    f.time[k] = interval_ * static_cast<double>(k + 1);
    f.max_tension[k] = largest.quantile(0.5);
    f.max_tension_p05[k] = largest.quantile(0.05);
    f.max_tension_p95[k] = largest.quantile(0.95);
    f.vessel_tension[k] = Sorted(vessel_.row(row), alive_).quantile(0.5);
    f.vehicle_tension[k] = Sorted(vehicle_.row(row), alive_).quantile(0.5);
    f.min_tension[k] = Sorted(least_.row(row), alive_).quantile(0.5);
  }
  const Sorted limit(to_limit_, alive_), warning(to_warning_, alive_), slack(to_slack_, alive_);
  f.probability_over_tension = limit.shareThatDo();
  f.probability_breaking = static_cast<double>((breaks_ && alive_).count()) / alive();
  f.probability_slack = slack.shareThatDo();
  f.time_to_warning = warning.medianOfThoseThatDo();
  f.time_to_limit = limit.medianOfThoseThatDo();
  f.time_to_slack = slack.medianOfThoseThatDo();
  f.time_to_limit_p05 = limit.timeOf(0.05);
  const double median = Sorted(peak_, alive_).quantile(0.5);
  double nearest = NEVER;
  for (Eigen::Index i = 0; i < peak_.size(); ++i)
    if (alive_[i] && std::abs(peak_[i] - median) < nearest)
    {
      nearest = std::abs(peak_[i] - median);
      f.place_s = place_[i];
      f.position = last_[i];
    }
}

}  // namespace tether_monitor::monitor
