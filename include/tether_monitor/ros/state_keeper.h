#pragma once

#include <ros/time.h>

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "tether_monitor/ros/priority_mutex.h"
#include "tether_monitor/ros/time_conversion.h"

namespace tether_monitor
{
/// The saved state of an estimator, and the origin of its seconds.
struct KeptState
{
  TimeOrigin time;
  std::vector<std::uint8_t> bytes;
};

/**
 * Keeps the state of an estimator in a file, for the node that comes after a crash. Writes in a thread of its own,
 * and as a whole: what is in the file is always one state or the one before it.
 */
class StateKeeper
{
 public:
  /// @param path  empty: nothing is kept. @throws std::runtime_error naming the file if it cannot be written.
  explicit StateKeeper(const std::string& path);
  /// Waits for what is being written.
  ~StateKeeper();
  StateKeeper(const StateKeeper&) = delete;
  StateKeeper& operator=(const StateKeeper&) = delete;

  bool isOn() const { return !path_.empty(); }
  /// What is in the file; nothing if there is none, or nothing that this program wrote.
  std::optional<KeptState> read() const;
  /// True if the last one is a second old at time t [s].
  bool isDue(double t) const { return isOn() && (t - submitted_ >= PERIOD || t < submitted_); }
  /// Hands one over, of time t [s]; what has not been written yet goes.
  void submit(double t, KeptState state);
  /// What went wrong last; empty: nothing.
  std::string problem() const;

 private:
  static constexpr double PERIOD = 1.0;  // [s]
  void run();
  std::string write(const KeptState& state) const;

  const std::string path_;
  double submitted_ = -1e300;
  mutable PriorityMutex mutex_;
  std::condition_variable_any wake_;
  std::optional<KeptState> waiting_;  // guarded by mutex_, as are those below
  std::string problem_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace tether_monitor
