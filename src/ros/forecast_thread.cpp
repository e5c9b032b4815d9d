#include "tether_monitor/ros/forecast_thread.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <ctime>

#include "tether_monitor/replay/cpu_clock.h"

namespace tether_monitor
{
namespace
{
constexpr double MOST_SHARE = 0.18;   // of the interval that forecasts and recommendations may take
constexpr double LITTLE_SHARE = 0.1;  // below it there may be more again
constexpr int FEWEST_MEMBERS = 16;
constexpr int RECOMMENDING_MEMBERS = 24;
constexpr int FORECASTS_A_RECOMMENDATION = 2;
constexpr double LONGEST_INTERVAL = 10.0;  // [s]
constexpr double GROWTH = 1.25;
constexpr double FASTER = 1.5, FASTER_BY = 0.5;          // than now: the largest speed that is tried [-, m/s]
constexpr double LEAST_RATE = -1.0, LARGEST_RATE = 2.0;  // of the winch that are tried [m/s]
constexpr int LOW_PRIORITY = 10;                         // nice

double wallTime()
{
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}
}  // namespace

ForecastBudget::ForecastBudget(const monitor::ForecastConfig& config)
  : config_(config), members_(config.members), interval_(config.rate > 0.0 ? 1.0 / config.rate : 1e300)
{
}

bool ForecastBudget::isShort() const
{
  return config_.rate > 0.0 && (members_ < config_.members || interval_ > 1.0 / config_.rate * (1.0 + 1e-9));
}

void ForecastBudget::note(double took)
{
  const double share = took / interval_;
  const int fewest = std::min(FEWEST_MEMBERS, config_.members);
  if (share > MOST_SHARE)
  {
    if (members_ > fewest)
      members_ = std::max(fewest, static_cast<int>(members_ * MOST_SHARE / share));
    else
      interval_ = std::min(interval_ * GROWTH, LONGEST_INTERVAL);
    return;
  }
  if (share > LITTLE_SHARE)
    return;
  if (interval_ > 1.0 / config_.rate)
    interval_ = std::max(interval_ / GROWTH, 1.0 / config_.rate);
  else
    members_ = std::min(static_cast<int>(std::ceil(members_ * GROWTH)), config_.members);
}

ForecastThread::ForecastThread(const monitor::Config& config, Ready ready)
  : schedule_(config.forecast),
    ready_(std::move(ready)),
    config_(config),
    budget_(config.forecast),
    speed_(monitor::TetherForecast::NONE),
    payout_rate_(monitor::TetherForecast::NONE)
{
  makeForecaster(config);
  thread_ = std::thread([this] { run(); });
}

ForecastThread::~ForecastThread()
{
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

bool ForecastThread::isDue(double t) const
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  return !is_busy_ && schedule_.rate > 0.0 && (t >= last_ + budget_.interval() - 1e-6 || t < last_);
}

void ForecastThread::submit(Start start)
{
  {
    const std::lock_guard<PriorityMutex> lock(mutex_);
    if (is_busy_)
      return;
    is_busy_ = true;
    last_ = start->t;
    waiting_ = std::move(start);
  }
  wake_.notify_all();
}

ForecastBudget ForecastThread::budget() const
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  return budget_;
}

void ForecastThread::reconfigure(const monitor::Config& config)
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  config_ = config;
  is_reconfigured_ = true;
}

void ForecastThread::makeForecaster(const monitor::Config& config)
{
  forecaster_.emplace(config);
  forecaster_->stopWhen(is_over_);
}

void ForecastThread::run()
{
  setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), LOW_PRIORITY);
  while (true)
  {
    Start start;
    {
      std::unique_lock<PriorityMutex> lock(mutex_);
      wake_.wait(lock, [this] { return waiting_ || is_over_; });
      if (is_over_)
        return;
      start = std::move(waiting_);
      waiting_.reset();
      if (is_reconfigured_)
        makeForecaster(config_);
      is_reconfigured_ = false;
    }
    const double took = forecast(*start);
    const std::lock_guard<PriorityMutex> lock(mutex_);
    budget_.note(took);
    is_busy_ = false;
  }
}

double ForecastThread::forecast(const monitor::ForecastStart& start)
{
  const int members = budget().members();
  const double began = replay::cpuClock(), wall = wallTime();
  double forecasting = 0.0;
  monitor::TetherForecast forecast;
  try
  {
    forecast = forecaster_->run(start, schedule_.horizon, members);
    forecasting = wallTime() - wall;
    if (count_++ % FORECASTS_A_RECOMMENDATION == 0)
    {
      recommend(start, std::min(members, RECOMMENDING_MEMBERS));
      recommending_ = wallTime() - wall - forecasting;
    }
  }
  catch (const std::exception&)
  {
    forecast = monitor::TetherForecast();  // out of memory: none
    forecast.t = start.t;
  }
  if (forecast.members > 0)
  {
    forecast.recommended_vessel_speed = speed_;
    forecast.recommended_payout_rate = payout_rate_;
  }
  forecast.computing_time = replay::cpuClock() - began;
  ready_(forecast);
  return forecasting + recommending_ / FORECASTS_A_RECOMMENDATION;
}

void ForecastThread::recommend(const monitor::ForecastStart& start, int members)
{
  const double horizon = schedule_.horizon;
  if (recommends_speed_)
    speed_ = forecaster_->largestVesselSpeed(
        start, horizon, members,
        FASTER_BY + FASTER * std::hypot(start.vessel.axis(0).mean()[1], start.vessel.axis(1).mean()[1]));
  else
    payout_rate_ = start.has_winch
                       ? forecaster_->leastPayoutRate(start, horizon, members, LEAST_RATE, LARGEST_RATE)
                       : monitor::TetherForecast::NONE;
  recommends_speed_ = !recommends_speed_;
}

monitor::TetherForecast ForecastThread::whatIf(const Start& start, double horizon,
                                               const monitor::ForecastActions& actions) const
{
  const double began = replay::cpuClock();
  monitor::TetherForecaster forecaster(
      [this]
      {
        const std::lock_guard<PriorityMutex> lock(mutex_);
        return config_;
      }());
  monitor::TetherForecast forecast = forecaster.run(*start, horizon, budget().members(), actions);
  forecast.computing_time = replay::cpuClock() - began;
  return forecast;
}

}  // namespace tether_monitor
