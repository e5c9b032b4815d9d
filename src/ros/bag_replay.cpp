#include "tether_monitor/ros/bag_replay.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <stdexcept>

#include "tether_monitor/ros/diagnostics.h"
#include "tether_monitor/ros/measurement_intake.h"

namespace tether_monitor
{
namespace
{
constexpr double DEFAULT_RATE = 20.0;  // [Hz]

// One input message, ready to be taken at its stamp.
struct Input
{
  ros::Time stamp;
  bool is_pose;
  BodyName body;
  std::string topic;
  std::function<std::string(MeasurementIntake&)> take;
};

struct Recording
{
  std::vector<Input> inputs;
  tf2::BufferCore transforms{ros::Duration(1e9)};
  std::map<std::string, RefusalCount> refusals;
};

void openBag(const std::string& path, rosbag::Bag& bag)
{
  try
  {
    bag.open(path, rosbag::bagmode::Read);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("cannot read the bag " + path + ": " + error.what() +
                             " (a truncated bag may be mended with rosbag reindex)");
  }
}

template <typename Message>
bool addBody(const rosbag::MessageInstance& instance, const std::string& topic, BodyName body, bool is_pose,
             Recording& recording)
{
  const auto message = instance.instantiate<Message>();
  if (!message)
    return false;
  recording.inputs.push_back({message->header.stamp, is_pose, body, topic,
                              [message, body](MeasurementIntake& intake)
                              { return intake.take(body, *message, message->header.stamp); }});
  return true;
}

template <typename Message>
bool addOther(const rosbag::MessageInstance& instance, const std::string& topic, Recording& recording)
{
  const auto message = instance.instantiate<Message>();
  if (!message)
    return false;
  recording.inputs.push_back({message->header.stamp, false, BodyName::VESSEL, topic,
                              [message](MeasurementIntake& intake)
                              { return intake.take(*message, message->header.stamp); }});
  return true;
}

void addTransforms(const rosbag::MessageInstance& instance, bool is_static, Recording& recording)
{
  if (const auto message = instance.instantiate<tf2_msgs::TFMessage>())
    for (const geometry_msgs::TransformStamped& transform : message->transforms)
      recording.transforms.setTransform(transform, "bag", is_static);
}

void addMessage(const rosbag::MessageInstance& m, const std::string& topic, Recording& recording)
{
  bool known = true;
  for (const auto& [name, body] : {std::make_pair(std::string("vessel"), BodyName::VESSEL),
                                   std::make_pair(std::string("vehicle"), BodyName::VEHICLE)})
  {
    if (topic == name + "/pose")
      known = addBody<geometry_msgs::PoseStamped>(m, topic, body, true, recording);
    else if (topic == name + "/odom")
      known = addBody<nav_msgs::Odometry>(m, topic, body, true, recording);
    else if (topic == name + "/velocity")
      known = addBody<geometry_msgs::TwistStamped>(m, topic, body, false, recording);
  }
  if (topic == "payout")
    known = addOther<Payout>(m, topic, recording);
  else if (topic == "current")
    known = addOther<CurrentProfile>(m, topic, recording);
  if (!known)
  {
    RefusalCount& refusal = recording.refusals[topic];
    ++refusal.count;
    refusal.last_reason = "its type is " + m.getDataType();
  }
}

std::string prefixOf(const std::string& ns)
{
  std::string prefix = "/" + ns + "/";
  while (prefix.find("//") != std::string::npos)
    prefix.replace(prefix.find("//"), 2, "/");
  return prefix;
}

[[noreturn]] void failWithoutTopics(const std::string& path, const std::string& prefix, rosbag::View& all)
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
  std::string text = "the bag " + path + " has no poses of both vessel and vehicle: expected " + prefix +
                     "vessel/pose or " + prefix + "vessel/odom, and " + prefix + "vehicle/pose or " + prefix +
                     "vehicle/odom. ";
  if (topics.empty())
    text += "It holds no messages at all.";
  else
  {
    text += "Its topics are:";
    for (const std::string& topic : topics)
      text += " " + topic;
  }
  for (const std::string& hint : hints)
    text += "\nTry --ns " + hint;
  throw std::runtime_error(text);
}

void readBag(const std::string& path, const std::string& ns, Recording& recording)
{
  rosbag::Bag bag;
  openBag(path, bag);
  const std::string prefix = prefixOf(ns);
  rosbag::View all(bag);
  try
  {
    for (const rosbag::MessageInstance& m : all)
    {
      const std::string& topic = m.getTopic();
      const std::string rooted = topic.empty() || topic[0] != '/' ? "/" + topic : topic;
      if (rooted == "/tf" || rooted == "/tf_static")
        addTransforms(m, rooted == "/tf_static", recording);
      else if (rooted.compare(0, prefix.size(), prefix) == 0)
        addMessage(m, rooted.substr(prefix.size()), recording);
    }
  }
  catch (const rosbag::BagException& error)
  {
    throw std::runtime_error("the bag " + path + " is damaged: " + error.what());
  }
  const auto hasPose = [&](BodyName body)
  {
    return std::any_of(recording.inputs.begin(), recording.inputs.end(),
                       [body](const Input& input) { return input.is_pose && input.body == body; });
  };
  if (!hasPose(BodyName::VESSEL) || !hasPose(BodyName::VEHICLE))
    failWithoutTopics(path, prefix, all);
  std::stable_sort(recording.inputs.begin(), recording.inputs.end(),
                   [](const Input& a, const Input& b) { return a.stamp < b.stamp; });
}
}  // namespace

std::vector<std::string> replayBag(const std::string& path, const std::string& ns,
                                   const replay::ReplayOptions& options, monitor::TetherEstimator& estimator,
                                   replay::Recorder& recorder)
{
  Recording recording;
  readBag(path, ns, recording);
  const std::vector<Input>& inputs = recording.inputs;
  const auto stamped =
      std::find_if(inputs.begin(), inputs.end(), [](const Input& i) { return !i.stamp.isZero(); });
  if (stamped == inputs.end())
    throw std::runtime_error("the bag " + path + " has no message of ours with a stamp");
  const TimeBase base(stamped->stamp);
  MeasurementIntake intake(estimator, recording.transforms);
  intake.setTimeBase(base);

  std::size_t next = 0;
  const auto takeNext = [&]
  {
    const Input& input = inputs[next++];
    const std::string why = input.take(intake);
    if (why.empty())
      return;
    RefusalCount& refusal = recording.refusals[input.topic];
    ++refusal.count;
    refusal.last_reason = why;
  };
  // Start when both bodies are known.
  while (next < inputs.size() && !(estimator.vessel().hasPose() && estimator.vehicle().hasPose()))
    takeNext();
  const auto warnings = [&]
  {
    std::vector<std::string> texts;
    for (const auto& [topic, refusal] : recording.refusals)
      texts.push_back(std::to_string(refusal.count) + " message(s) on " + topic +
                      " refused, last: " + refusal.last_reason);
    return texts;
  };
  if (!estimator.vessel().hasPose() || !estimator.vehicle().hasPose())
  {
    std::string text = "the bag " + path + ": every pose of vessel or vehicle was refused";
    for (const std::string& warning : warnings())
      text += "\n  " + warning;
    throw std::runtime_error(text);
  }

  const double begin = std::max(estimator.vessel().lastPoseTime(), estimator.vehicle().lastPoseTime());
  const double end = std::max(begin, base.seconds(inputs.back().stamp));
  const double rate = options.rate > 0.0 ? options.rate : DEFAULT_RATE;
  const long ticks = static_cast<long>((end - begin) * rate + 1e-6) + 1;
  for (long i = 0; i < ticks; ++i)
  {
    const double t = begin + i / rate;
    const auto wanted = [&](double stamp)
    {
      const bool covered = estimator.vessel().covers(t) && estimator.vehicle().covers(t);
      return stamp <= t || (!covered && stamp <= t + estimator.config().pose_timeout);
    };
    while (next < inputs.size() && wanted(base.seconds(inputs[next].stamp)))
      takeNext();
    recorder.beginStep();
    if (i == 0)
      estimator.beginFromTracks(t);
    else
      estimator.tick(t);
    recorder.endStep();
    recorder.observe(estimator);
    recorder.write(estimator);
    if (options.progress)
      options.progress((i + 1.0) / ticks);
  }
  return warnings();
}

}  // namespace tether_monitor
