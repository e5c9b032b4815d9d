#pragma once

#include <ros/ros.h>
#include <rosbag/message_instance.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/ros/input_adapter.h"

namespace tether_monitor
{
/// Which inputs follow each other in time, for a replay.
enum class InputStream
{
  VESSEL,
  VEHICLE,
  OTHER
};

/// One message, ready to be given to an adapter.
struct InputMessage
{
  std::optional<ros::Time> stamp;  ///< of its header; none: it has none and counts from when it came.
  std::string publisher;           ///< name of the node that sent it.
  std::function<std::optional<InputError>(InputAdapter&, const ros::Time& now)> accept;
};

/**
 * A topic that the monitor subscribes to.
 *
 * The one table of inputs: node and replay of bags follow it, tests compare README.md and launch/sim.launch with
 * it. A new input is an entry here, an accept() of InputAdapter, and a test: CONTRIBUTING.md has the recipe.
 */
struct InputTopic
{
  using Callback = std::function<void(const InputMessage&)>;

  std::string name;     ///< relative.
  std::string type;     ///< of its messages.
  std::string meaning;  ///< a phrase for the documents.
  InputStream stream = InputStream::OTHER;
  bool is_pose = false;  ///< says where the body of its stream is.
  std::function<ros::Subscriber(ros::NodeHandle&, const Callback&)> subscribe;
  /// Nothing if the message is of another type.
  std::function<std::optional<InputMessage>(const rosbag::MessageInstance&)> read;
};

/// All of them.
const std::vector<InputTopic>& inputTopics();
/// That with a relative name; null if there is none.
const InputTopic* findInputTopic(const std::string& name);

}  // namespace tether_monitor
