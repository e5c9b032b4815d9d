#pragma once

#include <atomic>

#include "tether_monitor/monitor/forecast/forecast_actions.h"
#include "tether_monitor/monitor/forecast/forecast_start.h"
#include "tether_monitor/monitor/forecast/forecast_traces.h"

namespace tether_monitor::monitor
{
struct EndSamplers;

/**
 * Runs the members of an estimate on: each with its own parameters, its own continuation of the vessel's motion
 * and its own unknown force, (F1)-(F3) of doc/theory/forecast.md. Allocates; for a thread of its own. Never throws
 * but for want of memory.
 */
class TetherForecaster
{
 public:
  explicit TetherForecaster(const Config& config);

  /// What runs ends soon, without members, once the flag is true; it must outlive its users.
  void stopWhen(const std::atomic<bool>& flag) { stop_ = &flag; }

  /// @param horizon  [s], > 0. @param members  wanted, >= 2; those of the start are used evenly, or several times.
  /// @return         without members if more than a quarter of them could not be stepped.
  TetherForecast run(const ForecastStart& start, double horizon, int members,
                     const ForecastActions& actions = ForecastActions());

  /**
   * Largest speed of the vessel on its present way, or least pay-out rate, with which at most one member in twenty
   * passes the limit; within `low` and `high` [m/s], by bisection. NaN if neither does, if
   * nothing is limited, or if the vessel makes no way.
   */
  double largestVesselSpeed(const ForecastStart& start, double horizon, int members, double high);
  double leastPayoutRate(const ForecastStart& start, double horizon, int members, double low, double high);

 private:
  // How much is simulated: a question ends once more members pass the limit than are tolerated.
  struct Extent
  {
    double horizon;  // [s]
    int members;
    int tolerated;  // as many as members: all of it is of interest
    bool isQuestion() const { return tolerated < members; }
  };
  void simulate(const ForecastStart& start, const Extent& extent, const ForecastActions& actions);
  bool simulateMember(const ForecastStart& start, const Extent& extent, int index, const ForecastActions& actions,
                      const EndSamplers& samplers, core::AdaptiveStepper& stepper);
  bool isSafe(const ForecastStart& start, double horizon, int members, const ForecastActions& actions);

  bool isStopped() const { return stop_ && *stop_; }

  const std::atomic<bool>* stop_ = nullptr;
  ForecastLimits limits_;
  core::RigidBody body_;
  TetherEstimate estimate_;  // of one member at one time
  ForecastTraces traces_;
};

}  // namespace tether_monitor::monitor
