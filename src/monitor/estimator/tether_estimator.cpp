#include "tether_monitor/monitor/estimator/tether_estimator.h"

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/monitor/estimator/estimator_snapshot.h"

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

TetherEstimator::TetherEstimator(const Config& config) : config_(checked(config)), cycle_(config), alarms_(config)
{
}

void TetherEstimator::setCurrent(const core::CurrentProfile& current)
{
  cycle_.setEnvironment(simulation().model.environment().withCurrent(current));
}

void TetherEstimator::setEpoch(double epoch)
{
  cycle_.setEnvironment(simulation().model.environment().withTimeOrigin(epoch));
}

const TetherEstimate& TetherEstimator::watched(const TetherEstimate& estimate)
{
  alarms_changed_ = alarms_.update(estimate);
  if (!isRunning())
    forecast_inputs_.clear();
  else if (estimate.has_stations)
    forecast_inputs_.observe(simulation(), vehicle());
  return estimate;
}

const TetherEstimate& TetherEstimator::tick(double t)
{
  if (phase() != Phase::IDLE && t < estimate().time)
    alarms_.resetTimers();
  return watched(cycle_.tick(t));
}

void TetherEstimator::reset()
{
  cycle_.reset();
  alarms_.resetTimers();
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
