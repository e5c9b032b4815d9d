#pragma once

#include <ros/time.h>
#include <tf2_msgs/TFMessage.h>

#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <boost/shared_ptr.hpp>

#include "tether_monitor/ros/input_topics.h"

namespace tether_monitor
{
/// One message between its callback and the cycle that takes it: of an input topic, or transforms.
struct ReceivedMessage
{
  const InputSource* source = nullptr;  ///< null: transforms, or a message that could not be read.
  InputMessage message;
  std::string topic;  ///< relative name.
  std::optional<InputError> unreadable;
  boost::shared_ptr<const tf2_msgs::TFMessage> transforms;
  bool are_static = false;
  ros::Time received;           ///< of the input clock.
  ros::WallTime received_wall;  ///< of the machine's.
};

/// Messages in the order in which they came; the callbacks never wait for the estimator. One thread puts, one
/// takes.
class InputQueue
{
 public:
  static constexpr std::size_t CAPACITY = 4096;

  /// @return false, and it is counted, if there is no room.
  bool push(const ReceivedMessage& message)
  {
    const bool has_room = queue_.push(message);
    if (!has_room)
      ++lost_;
    return has_room;
  }
  /// Calls take(message) for each that is there now.
  template <typename Take>
  void drain(const Take& take)
  {
    ReceivedMessage message;
    for (std::size_t k = 0; k < CAPACITY && queue_.pop(message); ++k)
      take(message);
  }
  long lost() const { return lost_; }

 private:
  boost::lockfree::spsc_queue<ReceivedMessage, boost::lockfree::capacity<CAPACITY>> queue_;
  std::atomic<long> lost_{0};
};

}  // namespace tether_monitor
