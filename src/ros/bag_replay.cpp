#include "tether_monitor/ros/bag_replay.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "tether_monitor/ros/crash_guard.h"
#include "tether_monitor/ros/diagnostics.h"
#include "tether_monitor/ros/input_adapter.h"
#include "tether_monitor/ros/input_topics.h"
#include "tether_monitor/ros/transform_input.h"

namespace tether_monitor
{
namespace
{
constexpr double DEFAULT_RATE = 20.0;  // [Hz]

// Each body has its own stream: looking ahead on one takes nothing of another.
constexpr std::size_t STREAMS = 3;
constexpr std::array<InputStream, STREAMS> ALL_STREAMS{InputStream::VESSEL, InputStream::VEHICLE,
                                                       InputStream::OTHER};

// One input message, ready to be given to the estimator.
struct Input
{
  ros::Time stamp;
  ros::Time recorded;
  const InputTopic* topic;
  InputMessage message;

  ros::Time arrival() const { return std::max(stamp, recorded); }
};

// Inputs of one kind, in order of their stamps.
struct Stream
{
  std::vector<Input> inputs;
  std::size_t next = 0;

  bool hasNext() const { return next < inputs.size(); }
};

struct Recording
{
  std::array<Stream, STREAMS> streams;
  tf2::BufferCore transforms{ros::Duration(1e9)};
  std::map<std::string, RefusalCount> refusals;

  Stream& at(InputStream stream) { return streams[static_cast<std::size_t>(stream)]; }
  const Stream& at(InputStream stream) const { return streams[static_cast<std::size_t>(stream)]; }
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

void refuse(const std::string& topic, const InputError& why, Recording& recording)
{
  RefusalCount& refusal = recording.refusals[topic];
  ++refusal.count;
  refusal.last_reason = why;
}

void addTransformsOf(const rosbag::MessageInstance& instance, bool is_static, Recording& recording)
{
  if (const auto message = instance.instantiate<tf2_msgs::TFMessage>())
    if (const auto error = addTransforms(*message, is_static, ros::Time(), recording.transforms))
      refuse(instance.getTopic(), *error, recording);
}

void addMessage(const rosbag::MessageInstance& m, const std::string& name, Recording& recording)
{
  const InputTopic* topic = findInputTopic(name);
  if (!topic)
    return;
  if (const std::optional<InputMessage> message = topic->read(m))
  {
    const ros::Time recorded = m.getTime();
    recording.at(topic->stream).inputs.push_back({message->stamp.value_or(recorded), recorded, topic, *message});
    return;
  }
  refuse(name, "its type is " + m.getDataType() + ", not " + topic->type, recording);
}

std::string prefixOf(const std::string& ns)
{
  std::string prefix = "/" + ns + "/";
  while (prefix.find("//") != std::string::npos)
    prefix.replace(prefix.find("//"), 2, "/");
  return prefix;
}

std::vector<InputStream> bodiesNeeded(bool needs_vehicle)
{
  if (needs_vehicle)
    return {InputStream::VESSEL, InputStream::VEHICLE};
  return {InputStream::VESSEL};
}

std::vector<std::string> warningsOf(const Recording& recording)
{
  std::vector<std::string> texts;
  for (const auto& [topic, refusal] : recording.refusals)
    texts.push_back(std::to_string(refusal.count) + " message(s) on " + topic +
                    " refused, last: " + refusal.last_reason);
  return texts;
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
                                    const Recording& recording, rosbag::View& all)
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
  for (const std::string& warning : warningsOf(recording))
    text += "\n" + warning;
  for (const std::string& hint : hints)
    text += "\nTry --ns " + hint;
  throw std::runtime_error(text);
}

// One wrong clock of the recorder must not make the run as long as to its time.
void dropStrayRecords(Recording& recording)
{
  constexpr double FARTHEST = 30.0 * 86400.0;  // [s] from the middle of the recording
  std::vector<ros::Time> times;
  for (const Stream& stream : recording.streams)
    for (const Input& input : stream.inputs)
      times.push_back(input.recorded);
  if (times.empty())
    return;
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  const ros::Time usual = *middle;
  for (Stream& stream : recording.streams)
  {
    const auto isStray = [&](const Input& input)
    { return std::abs(secondsBetween(input.recorded, usual)) > FARTHEST; };
    for (const Input& input : stream.inputs)
      if (isStray(input))
        refuse(input.topic->name, "it was recorded more than 30 days from the others", recording);
    stream.inputs.erase(std::remove_if(stream.inputs.begin(), stream.inputs.end(), isStray), stream.inputs.end());
  }
}

void readBag(const std::string& path, const std::string& ns, bool needs_vehicle, Recording& recording)
{
  const CrashGuard crash("the bag is damaged beyond what can be read\n");
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
        addTransformsOf(m, rooted == "/tf_static", recording);
      else if (rooted.compare(0, prefix.size(), prefix) == 0)
        addMessage(m, rooted.substr(prefix.size()), recording);
    }
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("the bag " + path + " is damaged: " + error.what());
  }
  dropStrayRecords(recording);
  // What is measured of a free vehicle is not used.
  if (!needs_vehicle)
    recording.at(InputStream::VEHICLE).inputs.clear();
  for (const InputStream body : bodiesNeeded(needs_vehicle))
  {
    const std::vector<Input>& inputs = recording.at(body).inputs;
    if (std::none_of(inputs.begin(), inputs.end(), [](const Input& input) { return input.topic->is_pose; }))
      failWithoutTopics(path, prefix, needs_vehicle, recording, all);
  }
  for (Stream& stream : recording.streams)
    std::stable_sort(stream.inputs.begin(), stream.inputs.end(),
                     [](const Input& a, const Input& b) { return a.stamp < b.stamp; });
}

// As the messages came in, late ones late.
void sortByArrival(Recording& recording)
{
  for (Stream& stream : recording.streams)
    std::stable_sort(stream.inputs.begin(), stream.inputs.end(),
                     [](const Input& a, const Input& b) { return a.arrival() < b.arrival(); });
}

void acceptNext(InputStream of, Recording& recording, InputAdapter& adapter)
{
  Stream& stream = recording.at(of);
  const Input& input = stream.inputs[stream.next++];
  const std::optional<InputError> error = input.message.accept(adapter, input.recorded);
  if (!error)
    return;
  refuse(input.topic->name, *error, recording);
}

const monitor::MotionBuffer& trackOf(InputStream body, const monitor::TetherEstimator& estimator)
{
  return body == InputStream::VESSEL ? estimator.vessel().track() : estimator.vehicle().track();
}

// Accepts what has arrived by time t.
void acceptArrived(double t, const TimeOrigin& base, Recording& recording, InputAdapter& adapter)
{
  for (const InputStream of : ALL_STREAMS)
  {
    const Stream& stream = recording.at(of);
    while (stream.hasNext() && base.seconds(stream.inputs[stream.next].arrival()) <= t)
      acceptNext(of, recording, adapter);
  }
}

// Accepts what is stamped up to time t, and of each body what comes next, so that its motion is interpolated.
void acceptAhead(double t, const TimeOrigin& base, const monitor::TetherEstimator& estimator, Recording& recording,
                 InputAdapter& adapter)
{
  const double furthest = t + estimator.config().pose_timeout;
  for (const InputStream of : ALL_STREAMS)
  {
    const Stream& stream = recording.at(of);
    while (stream.hasNext())
    {
      const double stamp = base.seconds(stream.inputs[stream.next].stamp);
      const bool is_enough = of == InputStream::OTHER || trackOf(of, estimator).canInterpolate(t);
      if (stamp > t && (is_enough || stamp > furthest))
        break;
      acceptNext(of, recording, adapter);
    }
  }
}

void acceptUntil(double t, const TimeOrigin& base, const monitor::TetherEstimator& estimator, Recording& recording,
                 InputAdapter& adapter)
{
  if (estimator.vehicle().acceptsLateMeasurements())
    acceptArrived(t, base, recording, adapter);
  else
    acceptAhead(t, base, estimator, recording, adapter);
}

// Stamps of the first and the last usable pose of a body: neither zero nor beyond the time of its recording.
std::pair<ros::Time, ros::Time> poseSpan(const Recording& recording, InputStream body, double tolerance)
{
  std::pair<ros::Time, ros::Time> span;
  for (const Input& input : recording.at(body).inputs)
    if (input.topic->is_pose && !input.stamp.isZero() && secondsBetween(input.stamp, input.recorded) <= tolerance)
    {
      if (span.first.isZero())
        span.first = input.stamp;
      span.second = input.stamp;
    }
  return span;
}
// Accepts messages until both bodies are known. @throws std::runtime_error if they never are.
void acceptFirstPoses(const std::string& path, const std::vector<InputStream>& bodies,
                      const monitor::TetherEstimator& estimator, Recording& recording, InputAdapter& adapter)
{
  for (const InputStream body : bodies)
  {
    while (recording.at(body).hasNext() && !trackOf(body, estimator).hasPose())
      acceptNext(body, recording, adapter);
    if (trackOf(body, estimator).hasPose())
      continue;
    std::string text = "the bag " + path + ": every pose of a body was refused";
    for (const std::string& warning : warningsOf(recording))
      text += "\n  " + warning;
    throw std::runtime_error(text);
  }
}
}  // namespace

std::vector<std::string> replayBag(const std::string& path, const std::string& ns,
                                   const replay::ReplayOptions& options, monitor::TetherEstimator& estimator,
                                   replay::ResultRecorder& recorder)
{
  Recording recording;
  const bool needs_vehicle = estimator.vehicle().needsPoses();
  const bool as_it_arrived = estimator.vehicle().acceptsLateMeasurements();
  readBag(path, ns, needs_vehicle, recording);
  if (as_it_arrived)
    sortByArrival(recording);
  const double tolerance = estimator.config().pose_timeout;
  const auto vessel = poseSpan(recording, InputStream::VESSEL, tolerance);
  const auto vehicle = poseSpan(recording, InputStream::VEHICLE, tolerance);
  const TimeOrigin base(needs_vehicle ? std::min(vessel.first, vehicle.first) : vessel.first);
  InputAdapter adapter(estimator, recording.transforms);
  adapter.setTimeBase(base);
  estimator.setEpoch(base.epoch());
  double begin = base.seconds(std::max(vessel.first, vehicle.first));
  if (!as_it_arrived)
  {
    acceptFirstPoses(path, bodiesNeeded(needs_vehicle), estimator, recording, adapter);
    begin = std::max(estimator.vessel().track().lastPoseTime(), estimator.vehicle().track().lastPoseTime());
  }

  // The model follows the motion at the monitor's rate or finer, whatever the rate of the output.
  const double end = std::max(begin, base.seconds(std::max(vessel.second, vehicle.second)));
  const double rate = options.rate > 0.0 ? options.rate : DEFAULT_RATE;
  const double longest = std::min(estimator.config().solver.step, 1.0 / estimator.config().rate);
  const int parts = std::max(1, static_cast<int>(std::ceil(1.0 / (rate * longest) - 1e-9)));
  const long outputs = static_cast<long>((end - begin) * rate + 1e-6) + 1;
  for (long i = 0; i < outputs; ++i)
  {
    for (int part = i == 0 ? parts : 1; part <= parts; ++part)
    {
      // To the nanosecond, as stamps are: a measurement of this very time counts.
      const double t = base.seconds(base.stamp(begin + (i - 1 + static_cast<double>(part) / parts) / rate));
      acceptUntil(t, base, estimator, recording, adapter);
      recorder.startTimer();
      if (i == 0 && !as_it_arrived)
        estimator.beginFromTracks(t);
      else
        estimator.tick(t);
      recorder.stopTimer();
      recorder.accumulate(estimator);
    }
    recorder.writeRow(estimator);
    if (options.is_interrupted && options.is_interrupted())
      return warningsOf(recording);
    if (options.progress)
      options.progress((i + 1.0) / outputs);
  }
  // What is left is accepted too: a stray stamp must not go unnoticed.
  acceptUntil(std::numeric_limits<double>::infinity(), base, estimator, recording, adapter);
  return warningsOf(recording);
}

}  // namespace tether_monitor
