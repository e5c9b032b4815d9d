#include "tether_monitor/ros/publishing_thread.h"

namespace tether_monitor
{
namespace
{
constexpr std::size_t MOST_WAITING = 4;  // outputs of which all is published
}

PublishingThread::PublishingThread(OutputPublisher& publisher) : publisher_(publisher), thread_([this] { run(); })
{
}

PublishingThread::~PublishingThread()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
  }
  wake_.notify_all();
  room_.notify_all();
  thread_.join();
}

// One place is always free for the next output: a cycle waits only if seven of them have not been published.
void PublishingThread::submit()
{
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++filled_;
  }
  wake_.notify_one();
  std::unique_lock<std::mutex> lock(mutex_);
  room_.wait(lock, [this] { return filled_ - published_ < outputs_.size() || is_over_; });
}

PublishingReport PublishingThread::report() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  return report_;
}

void PublishingThread::run()
{
  for (;;)
  {
    std::size_t number, waiting;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [this] { return published_ < filled_ || is_over_; });
      if (is_over_)
        return;
      number = published_;
      waiting = filled_ - published_;
    }
    publish(outputs_[number % outputs_.size()], waiting > MOST_WAITING);
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      ++published_;
    }
    room_.notify_one();
  }
}

void PublishingThread::publish(CycleOutput& output, bool is_behind)
{
  if (!is_behind)
    publisher_.publishFlag(output);
  publisher_.publishAlarms(output);
  if (!is_behind)
    publisher_.publishNumbers(output);
  const double latency = output.received.isZero() ? -1.0 : (ros::WallTime::now() - output.received).toSec();
  bool has_time;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (latency >= 0.0 && !is_behind)
      report_.input_to_output.add(latency);
    report_.shed_outputs += is_behind;
    has_time = published_ + 1 == filled_;
    report_.shed_markers += !has_time;
  }
  if (has_time)
    publisher_.publishMarkers(output);
}

}  // namespace tether_monitor
