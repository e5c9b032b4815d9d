#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace tether_monitor
{
/// Asks the ROS master every few seconds whether it is there, in a thread of its own: the question may take long.
class MasterWatch
{
 public:
  MasterWatch();
  ~MasterWatch();
  MasterWatch(const MasterWatch&) = delete;
  MasterWatch& operator=(const MasterWatch&) = delete;

  bool isLost() const { return is_lost_; }

 private:
  void watch();

  std::atomic<bool> is_lost_{false};
  bool ends_ = false;  // under mutex_
  std::mutex mutex_;
  std::condition_variable wake_;
  std::thread thread_;
};

}  // namespace tether_monitor
