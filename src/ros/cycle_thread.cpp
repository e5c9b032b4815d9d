#include "tether_monitor/ros/cycle_thread.h"

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <time.h>

#include <cerrno>
#include <cmath>
#include <cstring>

namespace tether_monitor
{
namespace
{
constexpr double LONGEST_SLEEP = 0.2;  // [s], so that an end is noticed

double monotonicTime()
{
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void sleepUntil(double t)
{
  timespec until{};
  until.tv_sec = static_cast<time_t>(std::floor(t));
  until.tv_nsec = static_cast<long>(1e9 * (t - std::floor(t)));
  while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR)
  {
  }
}
}  // namespace

CycleThread::CycleThread(double period, bool is_told, const monitor::RuntimeConfig& runtime, Work work)
  : period_(period), is_told_(is_told), runtime_(runtime), work_(std::move(work))
{
}

void CycleThread::start()
{
  if (runtime_.lock_memory && mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    refusal_ = std::string("memory cannot be locked: ") + std::strerror(errno);
  thread_ = std::thread([this] { run(); });
  if (runtime_.priority <= 0)
    return;
  sched_param parameters{};
  parameters.sched_priority = runtime_.priority;
  const int error = pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &parameters);
  if (error != 0)
    refusal_ += (refusal_.empty() ? "" : "; ") + std::string("SCHED_FIFO is refused: ") + std::strerror(error);
}

CycleThread::~CycleThread()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  if (thread_.joinable())
    thread_.join();
}

void CycleThread::notify()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_due_ = true;
  }
  wake_.notify_one();
}

bool CycleThread::isOver()
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return is_over_;
}

void CycleThread::run()
{
  is_told_ ? runWhenTold() : runOnClock();
}

void CycleThread::runWhenTold()
{
  for (;;)
  {
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [this] { return is_due_ || is_over_; });
      if (is_over_)
        return;
      is_due_ = false;
    }
    work_(0.0);
  }
}

void CycleThread::runOnClock()
{
  double due = monotonicTime() + period_;
  while (!isOver())
  {
    const double now = monotonicTime();
    if (now + LONGEST_SLEEP < due)
    {
      sleepUntil(now + LONGEST_SLEEP);
      continue;
    }
    sleepUntil(due);
    const double lateness = monotonicTime() - due;
    work_(lateness);
    due += period_ * (1.0 + std::floor(lateness / period_));
  }
}

}  // namespace tether_monitor
