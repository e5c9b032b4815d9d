#pragma once

#include <ros/ros.h>

#include <string>

namespace tether_monitor
{
/// The last message of a topic, and how many came.
template <typename Message>
class LastMessage
{
 public:
  explicit LastMessage(const std::string& topic)
  {
    subscriber_ = nh_.subscribe<Message>(topic, 100,
                                         [this](const typename Message::ConstPtr& message)
                                         {
                                           value = *message;
                                           ++count;
                                         });
  }
  Message value;
  int count = 0;

 private:
  ros::NodeHandle nh_;
  ros::Subscriber subscriber_;
};

}  // namespace tether_monitor
