#include "tether_monitor/ros/master_watch.h"

#include <ros/master.h>

#include <chrono>

namespace tether_monitor
{
namespace
{
constexpr std::chrono::seconds PERIOD{2};
}

MasterWatch::MasterWatch() : thread_([this] { watch(); })
{
}

MasterWatch::~MasterWatch()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ends_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void MasterWatch::watch()
{
  std::unique_lock<std::mutex> lock(mutex_);
  while (!wake_.wait_for(lock, PERIOD, [this] { return ends_; }))
  {
    lock.unlock();
    is_lost_ = !ros::master::check();
    lock.lock();
  }
}

}  // namespace tether_monitor
