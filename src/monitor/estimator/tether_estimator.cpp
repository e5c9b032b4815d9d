#include "tether_monitor/monitor/estimator/tether_estimator.h"

#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/monitor/estimator/estimator_snapshot.h"
#include "tether_monitor/monitor/estimator/live_settings.h"

namespace tether_monitor::monitor
{
namespace
{
const Config& checked(const Config& config)
{
  core::throwIfInvalid("configuration of the monitor", validateWithAlarms(config));
  return config;
}
}  // namespace

TetherEstimator::TetherEstimator(const Config& config)
  : config_(checked(config)), cycle_(config), alarm_inputs_(config), alarms_(config), forecast_inputs_(config)
{
}

std::vector<std::string> TetherEstimator::reconfigure(const Config& config)
{
  std::vector<std::string> problems = validateWithAlarms(config);
  if (problems.empty() && !differInLiveSettingsOnly(config_, config))
    problems.emplace_back(
        "only drag, uncertainties, thresholds and alarms can be changed while the monitor works");
  if (problems.empty() && phase() == Phase::STARTING)
    problems.emplace_back("the tether is settling: try again when it has");
  if (!problems.empty())
    return problems;
  TetherEstimator next(config);
  if (!EstimatorSnapshot::carryOver(*this, next))
    return {"the tether cannot go on with these numbers"};
  next.cycle_.vehicle().forgetWhatIsToldAnew(config_, config);
  next.setBackgroundStart(cycle_.startsInBackground());
  *this = std::move(next);
  return {};
}

void TetherEstimator::setCurrent(const core::CurrentProfile& current)
{
  cycle_.setEnvironment(simulation().model.environment().withCurrent(current));
}

void TetherEstimator::setEpoch(double epoch)
{
  cycle_.setEnvironment(simulation().model.environment().withTimeOrigin(epoch));
}

Rejection TetherEstimator::addTension(double t, double tension)
{
  const Rejection rejection = cycle_.vehicle().addTension(t, tension);
  if (rejection == Rejection::NONE && std::isfinite(tension) && std::isfinite(t))
    alarm_inputs_.addTension(t, tension);
  return rejection;
}

const TetherEstimate& TetherEstimator::watched(const TetherEstimate& estimate)
{
  alarms_changed_ = alarms_.update(
      estimate, alarm_inputs_.update(estimate, cycle_.simulation(), vessel(), vehicle(), vortexShedding()));
  if (!isRunning())
    forecast_inputs_.clear();
  else if (estimate.has_stations)
    forecast_inputs_.observe(estimate, simulation(), vehicle());
  return estimate;
}

const TetherEstimate& TetherEstimator::tick(double t)
{
  if (phase() != Phase::IDLE && t < estimate().time)
    alarms_.resetTimers(t);
  return watched(cycle_.tick(t));
}

void TetherEstimator::reset()
{
  cycle_.reset();
  alarms_.resetTimers(estimate().time);
  alarm_inputs_.clear();
  forecast_inputs_.clearPlans();
}

bool TetherEstimator::setPayoutPlan(const PayoutPlan& plan)
{
  const bool has_length = std::isnan(plan.length) || (plan.length >= 0.0 && std::isfinite(plan.length));
  if (!has_length || !std::isfinite(plan.rate) || !std::isfinite(plan.t))
    return false;
  forecast_inputs_.setPayoutPlan(plan);
  return true;
}

std::vector<ParameterEstimate> TetherEstimator::parameters() const
{
  const TetherEnsemble* ensemble = vehicle().ensemble();
  if (!ensemble || !isRunning())
    return {};
  return parameterReport(*ensemble, config_, simulation().length(),
                         simulation().model.environment().current().at(0.0));
}

std::optional<ForecastStart> TetherEstimator::forecastStart() const
{
  if (!isRunning() || !estimate().has_stations || !forecast_inputs_.isReady())
    return std::nullopt;
  return forecast_inputs_.start(simulation(), vehicle(), estimate().payout_rate);
}

std::vector<std::uint8_t> TetherEstimator::save() const
{
  return EstimatorSnapshot::save(*this);
}

bool TetherEstimator::restore(const std::vector<std::uint8_t>& bytes)
{
  return EstimatorSnapshot::restore(bytes, *this);
}

}  // namespace tether_monitor::monitor
