#pragma once

#include <topic_tools/shape_shifter.h>

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

struct InputSource;

/// One message, ready to be given to an adapter.
struct InputMessage
{
  std::optional<ros::Time> stamp;  ///< of its header; none: it has none and counts from when it came.
  std::string publisher;           ///< name of the node that sent it.
  std::function<std::optional<InputError>(InputAdapter&, const ros::Time& now)> accept;
};

/// A type of message that a topic may have.
struct InputType
{
  std::string name;  ///< package/Type
  /// @throws ros::Exception if the message is another version of the type.
  std::function<InputMessage(const topic_tools::ShapeShifter&, const InputSource&)> read;
};

/**
 * A topic that the monitor subscribes to, of whichever of its types is published there.
 *
 * The one table of inputs: node and replay of bags follow it, tests compare doc/interfaces.md and
 * launch/sim.launch with it. A new input is an entry here, a take() of MotionInputAdapter or SensorInputAdapter or
 * an accept() of InputAdapter, and a test: CONTRIBUTING.md has the recipe.
 */
struct InputTopic
{
  std::string name;  ///< relative.
  std::vector<InputType> types;
  std::string meaning;  ///< a phrase for the documents.
  InputStream stream = InputStream::OTHER;
  bool is_pose = false;  ///< says where the body of its stream is.

  /// "a/A, b/B or c/C"
  std::string typeNames() const;
};

/// All of them.
const std::vector<InputTopic>& inputTopics();
/// That with a relative name, with or without a number; null if there is none.
const InputTopic* findInputTopic(const std::string& name);

/// A topic as it is subscribed to: one of the table, or one more of its kind with a number, vehicle/pose2.
struct InputSource
{
  const InputTopic* topic = nullptr;
  monitor::SourceConfig config;  ///< its topic is the name.

  /// Where it is published: absolute, or relative.
  const std::string& published() const { return config.from.empty() ? config.topic : config.from; }
  /// @param publisher  name of the node that sent it.
  /// @param out        the message, if nothing is wrong with its type.
  std::optional<InputError> read(const topic_tools::ShapeShifter& message, const std::string& publisher,
                                 InputMessage& out) const;
};

/// Every topic of the table, and those with a number that the configuration names. @throws std::invalid_argument
/// naming a topic of the configuration that is none.
std::vector<InputSource> inputSources(const monitor::InputsConfig& config);

}  // namespace tether_monitor
