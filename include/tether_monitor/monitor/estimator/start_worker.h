#pragma once

#include <atomic>
#include <memory>
#include <thread>
#include <vector>

#include "tether_monitor/monitor/estimator/steady_start.h"

namespace tether_monitor::monitor
{
/**
 * Looks for a steady start in a thread of its own, from copies: a search may take seconds, a cycle may not.
 *
 * A copy of a worker is an idle one. The destructor waits for the search that runs.
 */
class StartWorker
{
 public:
  StartWorker() = default;
  StartWorker(const StartWorker&) {}
  StartWorker(StartWorker&& other) noexcept = default;
  StartWorker& operator=(const StartWorker& other);
  StartWorker& operator=(StartWorker&& other) noexcept;
  ~StartWorker();

  /// Nothing is searched, and no result waits.
  bool isIdle() const { return !job_; }
  bool isReady() const { return job_ && job_->is_done && !job_->is_discarded; }
  /// Begins a search, see findSteadyStart(); isIdle() must hold.
  void search(const Config& config, const CableSimulation& simulation,
              const std::vector<core::Obstacle>& obstacles, const VehicleEnd& vehicle, double t,
              const EndTargets& targets);
  /// What was found, and for which time [s] and ends; isReady() must hold. The worker is idle then.
  SteadyStart take(double& t, EndTargets& targets);
  /// The result, now or when it comes, is not wanted.
  void discard();
  /// Becomes idle once a search that is not wanted has ended.
  void collect();

 private:
  // All that the thread works with: it belongs to it until is_done.
  struct Job
  {
    Config config;
    std::vector<core::Obstacle> obstacles;
    std::unique_ptr<const VehicleEnd> vehicle;
    double t;
    EndTargets targets;
    SteadyStart found;
    std::atomic<bool> is_done{false};
    bool is_discarded = false;
    std::thread thread{};
  };
  void end();

  std::unique_ptr<Job> job_;
};

}  // namespace tether_monitor::monitor
