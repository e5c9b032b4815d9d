#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

#include "tether_monitor/monitor/forecast/tether_forecaster.h"
#include "tether_monitor/ros/priority_mutex.h"

namespace tether_monitor
{
/// How many members a forecast can afford, and how often there can be one: members go first, then the rate.
class ForecastBudget
{
 public:
  explicit ForecastBudget(const monitor::ForecastConfig& config);

  int members() const { return members_; }
  /// Time from one forecast to the next [s].
  double interval() const { return interval_; }
  /// True while it is less than what is configured.
  bool isShort() const;
  /// Accepts how long one has taken [s].
  void note(double took);

 private:
  monitor::ForecastConfig config_;
  int members_;
  double interval_;
};

/**
 * A thread of low priority that makes forecasts, one at a time: the cycle that hands it a start never waits for
 * it. The destructor breaks off the one that is under way.
 */
class ForecastThread
{
 public:
  using Start = std::shared_ptr<const monitor::ForecastStart>;
  using Ready = std::function<void(const monitor::TetherForecast&)>;

  /// @param ready  called in the thread for every forecast.
  ForecastThread(const monitor::Config& config, Ready ready);
  ~ForecastThread();
  ForecastThread(const ForecastThread&) = delete;
  ForecastThread& operator=(const ForecastThread&) = delete;

  /// True if one is due at time t [s] and nothing is under way.
  bool isDue(double t) const;
  /// Begins one; nothing happens if another is under way.
  void submit(Start start);
  /// A forecast for other actions, in the caller's thread. Safe to call from any.
  monitor::TetherForecast whatIf(const Start& start, double horizon,
                                 const monitor::ForecastActions& actions) const;
  ForecastBudget budget() const;
  /// With other limits and uncertainties, from the next forecast on; horizon and rate stay.
  void reconfigure(const monitor::Config& config);

 private:
  void run();
  void makeForecaster(const monitor::Config& config);
  // What it takes, with the share of a recommendation [s].
  double forecast(const monitor::ForecastStart& start);
  void recommend(const monitor::ForecastStart& start, int members);

  const monitor::ForecastConfig schedule_;
  const Ready ready_;
  mutable PriorityMutex mutex_;
  monitor::Config config_;  // guarded by mutex_
  bool is_reconfigured_ = false;
  std::condition_variable_any wake_;
  Start waiting_;  // guarded by mutex_, as are those below
  bool is_busy_ = false;
  std::atomic<bool> is_over_{false};
  double last_ = -1e300;  // [s] of the last start
  ForecastBudget budget_;
  std::optional<monitor::TetherForecaster> forecaster_;  // of the thread, as are those below
  long count_ = 0;                                       // forecasts
  double recommending_ = 0.0;                            // time that the last recommendation took [s]
  bool recommends_speed_ = true;                         // speed and pay-out take turns
  double speed_, payout_rate_;                           // last recommended [m/s]
  std::thread thread_;
};

}  // namespace tether_monitor
