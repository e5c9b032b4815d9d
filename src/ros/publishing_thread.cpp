#include "tether_monitor/ros/publishing_thread.h"

namespace tether_monitor
{
namespace
{
constexpr std::size_t MOST_WAITING = 4;   // outputs of which all is published
constexpr double ROOM_INTERVAL = 1.0e-3;  // [s] between looks for a free place
}  // namespace

PublishingThread::PublishingThread(OutputPublisher& publisher) : publisher_(publisher)
{
  sem_init(&waiting_, 0, 0);
  thread_ = std::thread([this] { run(); });
}

PublishingThread::~PublishingThread()
{
  is_over_ = true;
  sem_post(&waiting_);
  thread_.join();
  sem_destroy(&waiting_);
}

// One place is always free for the next output.
void PublishingThread::submit()
{
  ++filled_;
  sem_post(&waiting_);
  while (filled_ - published_ >= outputs_.size() && !is_over_)
    ros::WallDuration(ROOM_INTERVAL).sleep();
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
    while (sem_wait(&waiting_) != 0)
    {
    }
    if (is_over_)
      return;
    publish(outputs_[published_ % outputs_.size()], filled_ - published_ > MOST_WAITING);
    ++published_;
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
  const bool has_time = published_ + 1 == filled_;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (latency >= 0.0 && !is_behind)
      report_.input_to_output.add(latency);
    report_.shed_outputs += is_behind;
    report_.shed_markers += !has_time;
  }
  if (has_time)
    publisher_.publishMarkers(output);
}

}  // namespace tether_monitor
