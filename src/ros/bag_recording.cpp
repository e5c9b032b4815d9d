#include "tether_monitor/ros/bag_recording.h"

#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "tether_monitor/ros/bag_messages.h"
#include "tether_monitor/ros/crash_guard.h"
#include "tether_monitor/ros/transform_input.h"

namespace tether_monitor
{
namespace
{
std::string rooted(const std::string& topic)
{
  return topic.empty() || topic[0] != '/' ? "/" + topic : topic;
}

// A transform of the frame of a body is a pose of it, once all transforms are known.
void addTransformPose(Body body, const ros::Time& stamp, const ros::Time& recorded, BagRecording& recording)
{
  InputMessage message;
  message.stamp = stamp;
  message.accept = [body, stamp, &recording](InputAdapter& adapter,
                                             const ros::Time& now) -> std::optional<InputError>
  {
    geometry_msgs::PoseStamped pose;
    if (const auto error = recording.transform_poses.find(body, stamp, pose))
      return error;
    return adapter.accept(body, pose, now);
  };
  const InputSource& source = body == Body::VESSEL ? recording.vessel_frame : recording.vehicle_frame;
  recording.at(source.topic->stream).inputs.push_back({stamp, recorded, &source, message});
}

void addTransformsOf(const rosbag::MessageInstance& instance, bool is_static, BagRecording& recording)
{
  const auto message = instance.instantiate<tf2_msgs::TFMessage>();
  if (!message)
    return;
  if (const auto error = addTransforms(*message, is_static, ros::Time(), recording.transforms))
    recording.refuse(instance.getTopic(), *error);
  for (const geometry_msgs::TransformStamped& transform : message->transforms)
    for (const Body body : {Body::VESSEL, Body::VEHICLE})
      if (!is_static && transform.child_frame_id == recording.transform_poses.frame(body))
        addTransformPose(body, transform.header.stamp, instance.getTime(), recording);
}

// Sources by their topics in the bag: absolute as they are told, or below the prefix.
std::multimap<std::string, const InputSource*> sourcesByTopic(const std::vector<InputSource>& sources,
                                                              const std::string& prefix)
{
  std::multimap<std::string, const InputSource*> found;
  for (const InputSource& source : sources)
  {
    const std::string& published = source.published();
    found.emplace(published[0] == '/' ? published : prefix + published, &source);
  }
  return found;
}

// Topics that the configuration names and the bag does not have.
std::vector<std::string> missingTopics(const std::multimap<std::string, const InputSource*>& by_topic,
                                       bool needs_vehicle, rosbag::View& all)
{
  std::set<std::string> topics;
  for (const rosbag::ConnectionInfo* connection : all.getConnections())
    topics.insert(rooted(connection->topic));
  std::vector<std::string> texts;
  for (const auto& [topic, source] : by_topic)
    if (!source->config.from.empty() && (needs_vehicle || source->topic->stream != InputStream::VEHICLE) &&
        topics.count(topic) == 0)
      texts.push_back("the bag has no topic " + topic + ", from which " + source->config.topic + " is to be read");
  return texts;
}

void addMessage(const rosbag::MessageInstance& m, const InputSource& source, BagRecording& recording)
{
  const auto shape = m.instantiate<topic_tools::ShapeShifter>();
  InputMessage message;
  if (const std::optional<InputError> error = source.read(*shape, m.getCallerId(), message))
    return recording.refuse(source.config.topic, *error);
  const ros::Time recorded = m.getTime();
  recording.at(source.topic->stream)
      .inputs.push_back({message.stamp.value_or(recorded), recorded, &source, message});
}

std::string prefixOf(const std::string& ns)
{
  std::string prefix = "/" + ns + "/";
  while (prefix.find("//") != std::string::npos)
    prefix.replace(prefix.find("//"), 2, "/");
  return prefix;
}

// "/vessel/pose or /vessel/odom"
std::string poseTopics(InputStream body, const std::string& prefix)
{
  std::string text;
  for (const InputTopic& topic : inputTopics())
    if (topic.stream == body && topic.is_pose)
      text += (text.empty() ? "" : " or ") + prefix + topic.name;
  return text;
}

[[noreturn]] void failWithoutTopics(const std::string& path, const std::string& prefix, bool needs_vehicle,
                                    const BagRecording& recording, rosbag::View& all)
{
  std::set<std::string> topics;
  std::set<std::string> hints;
  for (const rosbag::ConnectionInfo* connection : all.getConnections())
  {
    topics.insert(connection->topic);
    const std::size_t at = connection->topic.rfind("/vessel/");
    if (at != std::string::npos && at > 0)
      hints.insert(connection->topic.substr(1, at - 1));
  }
  std::string text = "the bag " + path + " has no poses of " +
                     (needs_vehicle ? "both vessel and vehicle" : "the vessel") + ": expected ";
  for (const InputStream body : bodiesNeeded(needs_vehicle))
    text += (body == InputStream::VEHICLE ? ", and " : "") + poseTopics(body, prefix);
  text += ". ";
  if (topics.empty())
    text += "It holds no messages at all.";
  else
  {
    text += "Its topics are:";
    for (const std::string& topic : topics)
      text += " " + topic;
  }
  for (const std::string& warning : recording.warnings())
    text += "\n" + warning;
  for (const std::string& hint : hints)
    text += "\nTry --ns " + hint;
  throw std::runtime_error(text);
}

// One wrong clock of the recorder must not make the run as long as to its time.
void dropStrayRecords(BagRecording& recording)
{
  constexpr double FARTHEST = 30.0 * 86400.0;  // [s] from the middle of the recording
  std::vector<ros::Time> times;
  for (const BagStream& stream : recording.streams)
    for (const BagInput& input : stream.inputs)
      times.push_back(input.recorded);
  if (times.empty())
    return;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  const ros::Time usual = *middle;
  for (BagStream& stream : recording.streams)
  {
    const auto isStray = [&](const BagInput& input)
    { return std::abs(secondsBetween(input.recorded, usual)) > FARTHEST; };
    for (const BagInput& input : stream.inputs)
      if (isStray(input))
        recording.refuse(input.source->config.topic, "it was recorded more than 30 days from the others");
    stream.inputs.erase(std::remove_if(stream.inputs.begin(), stream.inputs.end(), isStray), stream.inputs.end());
  }
}

}  // namespace

std::vector<InputStream> bodiesNeeded(bool needs_vehicle)
{
  if (needs_vehicle)
    return {InputStream::VESSEL, InputStream::VEHICLE};
  return {InputStream::VESSEL};
}

BagRecording::BagRecording(const monitor::Config& config)
  : sources(inputSources(config.inputs)), transform_poses(config, transforms)
{
  vessel_frame.topic = findInputTopic("vessel/pose");
  vehicle_frame.topic = findInputTopic("vehicle/pose");
  vessel_frame.config.topic = "/tf: " + config.vessel.tf_frame;
  vehicle_frame.config.topic = "/tf: " + config.vehicle.tf_frame;
}

void BagRecording::refuse(const std::string& topic, const InputError& why)
{
  RefusalCount& refusal = refusals[topic];
  ++refusal.count;
  refusal.last_reason = why;
}

std::vector<std::string> BagRecording::warnings() const
{
  std::vector<std::string> texts = missing;
  for (const auto& [topic, refusal] : refusals)
    texts.push_back(std::to_string(refusal.count) + " message(s) on " + topic +
                    " refused, last: " + refusal.last_reason);
  return texts;
}

void BagRecording::read(const std::string& path, const std::string& ns, bool needs_vehicle)
{
  const CrashGuard crash("the bag is damaged beyond what can be read\n");
  rosbag::Bag bag;
  openBag(path, bag);
  const std::string prefix = prefixOf(ns);
  const auto by_topic = sourcesByTopic(sources, prefix);
  rosbag::View all(bag);
  missing = missingTopics(by_topic, needs_vehicle, all);
  visitMessages(path, all,
                [&](const rosbag::MessageInstance& m)
                {
                  const std::string topic = rooted(m.getTopic());
                  if (topic == "/tf" || topic == "/tf_static")
                    addTransformsOf(m, topic == "/tf_static", *this);
                  const auto [first, last] = by_topic.equal_range(topic);
                  for (auto source = first; source != last; ++source)
                    addMessage(m, *source->second, *this);
                  return true;
                });
  dropStrayRecords(*this);
  // What is measured of a free vehicle is not used.
  if (!needs_vehicle)
    at(InputStream::VEHICLE).inputs.clear();
  for (const InputStream body : bodiesNeeded(needs_vehicle))
  {
    const std::vector<BagInput>& inputs = at(body).inputs;
    if (std::none_of(inputs.begin(), inputs.end(),
                     [](const BagInput& input) { return input.source->topic->is_pose; }))
      failWithoutTopics(path, prefix, needs_vehicle, *this, all);
  }
  for (BagStream& stream : streams)
    std::stable_sort(stream.inputs.begin(), stream.inputs.end(),
                     [](const BagInput& a, const BagInput& b) { return a.stamp < b.stamp; });
}

}  // namespace tether_monitor
