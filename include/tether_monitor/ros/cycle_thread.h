#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "tether_monitor/monitor/config/runtime_config.h"

namespace tether_monitor
{
/**
 * The thread that the estimator works in: wakes up on an absolute clock, or, where time is simulated, when it is
 * told to. A cycle that takes too long makes it miss some; the others keep their times.
 */
class CycleThread
{
 public:
  /// @param lateness  after the cycle's time [s].
  using Work = std::function<void(double lateness)>;

  /// @param is_told  true: a cycle begins with notify(); false: every `period` [s].
  CycleThread(double period, bool is_told, const monitor::RuntimeConfig& runtime, Work work);
  /// Waits for the cycle that is under way.
  ~CycleThread();
  CycleThread(const CycleThread&) = delete;
  CycleThread& operator=(const CycleThread&) = delete;

  /// Begins; once.
  void start();
  /// A cycle is due; several that were not waited for are one.
  void notify();
  /// What the machine refused of priority and memory; empty: nothing.
  const std::string& refusal() const { return refusal_; }

 private:
  void run();
  void runOnClock();
  void runWhenTold();
  bool isOver();

  const double period_;
  const bool is_told_;
  const monitor::RuntimeConfig runtime_;
  const Work work_;
  std::string refusal_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool is_due_ = false, is_over_ = false;  // guarded by mutex_
  std::thread thread_;
};

}  // namespace tether_monitor
