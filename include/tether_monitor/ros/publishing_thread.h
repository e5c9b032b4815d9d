#pragma once

#include <semaphore.h>

#include <array>
#include <atomic>
#include <mutex>
#include <thread>

#include "tether_monitor/ros/output_publisher.h"
#include "tether_monitor/ros/publishing_report.h"

namespace tether_monitor
{
/**
 * Publishes in a thread of its own what cycles leave. When it cannot keep up it sheds, in this order: markers
 * while another output waits, then numbers and over_tension of outputs while more than three newer ones wait;
 * never alarms, events, and the newest over_tension.
 */
class PublishingThread
{
 public:
  explicit PublishingThread(OutputPublisher& publisher);
  ~PublishingThread();
  PublishingThread(const PublishingThread&) = delete;
  PublishingThread& operator=(const PublishingThread&) = delete;

  /// A place for the next output, with the memory of an old one; for one caller. submit() hands it over, and waits
  /// for nothing unless seven outputs have not been published.
  CycleOutput& next() { return outputs_[filled_ % outputs_.size()]; }
  void submit();
  PublishingReport report() const;

 private:
  void run();
  void publish(CycleOutput& output, bool is_behind);

  OutputPublisher& publisher_;
  std::array<CycleOutput, 8> outputs_;
  std::atomic<std::size_t> filled_{0}, published_{0};
  std::atomic<bool> is_over_{false};
  sem_t waiting_;  // counts the outputs that are not published
  mutable std::mutex mutex_;
  PublishingReport report_;  // guarded by mutex_, which the caller of submit() never takes
  std::thread thread_;
};

}  // namespace tether_monitor
