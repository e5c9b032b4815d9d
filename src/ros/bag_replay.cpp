#include "tether_monitor/ros/bag_replay.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "tether_monitor/ros/diagnostics.h"
#include "tether_monitor/ros/input_adapter.h"

namespace tether_monitor
{
namespace
{
constexpr double DEFAULT_RATE = 20.0;  // [Hz]

// Inputs of one kind, in order of their stamps. Each body has its own stream: looking ahead on one takes nothing
// of another.
enum Stream
{
  VESSEL_STREAM,
  VEHICLE_STREAM,
  OTHER_STREAM,
  STREAMS
};

// One input message, ready to be taken.
struct Input
{
  ros::Time stamp;
  ros::Time recorded;
  bool is_pose;
  std::string topic;
  std::function<std::string(InputAdapter&)> take;

  ros::Time arrival() const { return std::max(stamp, recorded); }
};

struct Recording
{
  std::array<std::vector<Input>, STREAMS> inputs;
  std::array<std::size_t, STREAMS> next{};
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
bool addBody(const rosbag::MessageInstance& instance, const std::string& topic, Body body, bool is_pose,
             Recording& recording)
{
  const auto message = instance.instantiate<Message>();
  if (!message)
    return false;
  const ros::Time recorded = instance.getTime();
  recording.inputs[body == Body::VESSEL ? VESSEL_STREAM : VEHICLE_STREAM].push_back(
      {message->header.stamp, recorded, is_pose, topic,
       [message, body, recorded](InputAdapter& adapter) { return adapter.accept(body, *message, recorded); }});
  return true;
}

template <typename Message>
bool addOther(const rosbag::MessageInstance& instance, const std::string& topic, Recording& recording)
{
  const auto message = instance.instantiate<Message>();
  if (!message)
    return false;
  const ros::Time recorded = instance.getTime();
  recording.inputs[OTHER_STREAM].push_back({message->header.stamp, recorded, false, topic,
                                            [message, recorded](InputAdapter& adapter)
                                            { return adapter.accept(*message, recorded); }});
  return true;
}

// A number without a stamp counts from when it was recorded.
bool addNumber(const rosbag::MessageInstance& instance, const std::string& topic,
               std::string (InputAdapter::*take)(const std_msgs::Float64&, const ros::Time&), Recording& recording)
{
  const auto message = instance.instantiate<std_msgs::Float64>();
  if (!message)
    return false;
  const ros::Time recorded = instance.getTime();
  recording.inputs[OTHER_STREAM].push_back({recorded, recorded, false, topic,
                                            [message, take, recorded](InputAdapter& adapter)
                                            { return (adapter.*take)(*message, recorded); }});
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
  for (const auto& [name, body] : {std::make_pair(std::string("vessel"), Body::VESSEL),
                                   std::make_pair(std::string("vehicle"), Body::VEHICLE)})
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
  else if (topic == "obstacles")
    known = addOther<ObstacleArray>(m, topic, recording);
  else if (topic == "vehicle/thrust")
    known = addOther<geometry_msgs::WrenchStamped>(m, topic, recording);
  else if (topic == "seabed")
    known = addNumber(m, topic, &InputAdapter::acceptDepth, recording);
  else if (topic == "turns")
    known = addNumber(m, topic, &InputAdapter::acceptTurns, recording);
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

std::vector<Stream> bodiesNeeded(bool free_vehicle)
{
  if (free_vehicle)
    return {VESSEL_STREAM};
  return {VESSEL_STREAM, VEHICLE_STREAM};
}

[[noreturn]] void failWithoutTopics(const std::string& path, const std::string& prefix, bool free_vehicle,
                                    rosbag::View& all)
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
                     (free_vehicle ? "the vessel" : "both vessel and vehicle") + ": expected " + prefix +
                     "vessel/pose or " + prefix + "vessel/odom";
  if (!free_vehicle)
    text += ", and " + prefix + "vehicle/pose or " + prefix + "vehicle/odom";
  text += ". ";
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

void readBag(const std::string& path, const std::string& ns, bool free_vehicle, Recording& recording)
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
  // What is measured of a simulated vehicle is not used.
  if (free_vehicle)
    recording.inputs[VEHICLE_STREAM].clear();
  for (const Stream body : bodiesNeeded(free_vehicle))
    if (std::none_of(recording.inputs[body].begin(), recording.inputs[body].end(),
                     [](const Input& input) { return input.is_pose; }))
      failWithoutTopics(path, prefix, free_vehicle, all);
  for (std::vector<Input>& stream : recording.inputs)
    std::stable_sort(stream.begin(), stream.end(),
                     [](const Input& a, const Input& b) { return a.stamp < b.stamp; });
}

// As the messages came in, late ones late.
void sortByArrival(Recording& recording)
{
  for (std::vector<Input>& stream : recording.inputs)
    std::stable_sort(stream.begin(), stream.end(),
                     [](const Input& a, const Input& b) { return a.arrival() < b.arrival(); });
}

void takeNext(Recording& recording, Stream stream, InputAdapter& adapter)
{
  const Input& input = recording.inputs[stream][recording.next[stream]++];
  const std::string why = input.take(adapter);
  if (why.empty())
    return;
  RefusalCount& refusal = recording.refusals[input.topic];
  ++refusal.count;
  refusal.last_reason = why;
}

// Takes what is known at time t, and of each body what comes next, so that its motion is interpolated.
void takeUntil(double t, const TimeOrigin& base, const monitor::TetherEstimator& estimator, Recording& recording,
               InputAdapter& adapter)
{
  const auto covered = [&](int stream)
  {
    return stream == OTHER_STREAM ||
           (stream == VESSEL_STREAM ? estimator.vesselTrack() : estimator.vehicleTrack()).covers(t);
  };
  for (int stream = 0; stream < STREAMS; ++stream)
    while (recording.next[stream] < recording.inputs[stream].size())
    {
      const Input& input = recording.inputs[stream][recording.next[stream]];
      if (estimator.isVehicleObserved())
      {
        if (base.seconds(input.arrival()) > t)
          break;
        takeNext(recording, static_cast<Stream>(stream), adapter);
        continue;
      }
      const double stamp = base.seconds(input.stamp);
      if (stamp > t && (covered(stream) || stamp > t + estimator.config().pose_timeout))
        break;
      takeNext(recording, static_cast<Stream>(stream), adapter);
    }
}

std::vector<std::string> warningsOf(const Recording& recording)
{
  std::vector<std::string> texts;
  for (const auto& [topic, refusal] : recording.refusals)
    texts.push_back(std::to_string(refusal.count) + " message(s) on " + topic +
                    " refused, last: " + refusal.last_reason);
  return texts;
}

// Stamps of the first and the last usable pose of a body: neither zero nor beyond the time of its recording.
std::pair<ros::Time, ros::Time> poseSpan(const Recording& recording, Stream body, double tolerance)
{
  std::pair<ros::Time, ros::Time> span;
  for (const Input& input : recording.inputs[body])
    if (input.is_pose && !input.stamp.isZero() && (input.stamp - input.recorded).toSec() <= tolerance)
    {
      if (span.first.isZero())
        span.first = input.stamp;
      span.second = input.stamp;
    }
  return span;
}
}  // namespace

std::vector<std::string> replayBag(const std::string& path, const std::string& ns,
                                   const replay::ReplayOptions& options, monitor::TetherEstimator& estimator,
                                   replay::ResultRecorder& recorder)
{
  Recording recording;
  const bool free_vehicle = estimator.isVehicleFree(), observed = estimator.isVehicleObserved();
  readBag(path, ns, free_vehicle, recording);
  if (observed)
    sortByArrival(recording);
  const double tolerance = estimator.config().pose_timeout;
  const auto vessel = poseSpan(recording, VESSEL_STREAM, tolerance);
  const auto vehicle = poseSpan(recording, VEHICLE_STREAM, tolerance);
  const TimeOrigin base(free_vehicle ? vessel.first : std::min(vessel.first, vehicle.first));
  InputAdapter adapter(estimator, recording.transforms);
  adapter.setTimeBase(base);
  estimator.setEpoch(base.epoch());

  // Start when both bodies are known.
  for (const Stream body : observed ? std::vector<Stream>() : bodiesNeeded(free_vehicle))
    while (recording.next[body] < recording.inputs[body].size() &&
           !(body == VESSEL_STREAM ? estimator.vesselTrack() : estimator.vehicleTrack()).hasPose())
      takeNext(recording, body, adapter);
  if (!observed && (!estimator.vesselTrack().hasPose() || !(free_vehicle || estimator.vehicleTrack().hasPose())))
  {
    std::string text = "the bag " + path + ": every pose of a body was refused";
    for (const std::string& warning : warningsOf(recording))
      text += "\n  " + warning;
    throw std::runtime_error(text);
  }

  // The model follows the motion at the monitor's rate or finer, whatever the rate of the output.
  const double begin =
      observed ? base.seconds(std::max(vessel.first, vehicle.first))
               : std::max(estimator.vesselTrack().lastPoseTime(), estimator.vehicleTrack().lastPoseTime());
  const double end = std::max(begin, base.seconds(std::max(vessel.second, vehicle.second)));
  const double rate = options.rate > 0.0 ? options.rate : DEFAULT_RATE;
  const double longest = std::min(estimator.config().solver.step, 1.0 / estimator.config().rate);
  const int parts = std::max(1, static_cast<int>(std::ceil(1.0 / (rate * longest) - 1e-9)));
  const long outputs = static_cast<long>((end - begin) * rate + 1e-6) + 1;
  for (long i = 0; i < outputs; ++i)
  {
    for (int part = i == 0 ? parts : 1; part <= parts; ++part)
    {
      const double t = begin + (i - 1 + static_cast<double>(part) / parts) / rate;
      takeUntil(t, base, estimator, recording, adapter);
      recorder.startTimer();
      if (i == 0 && !observed)
        estimator.beginFromTracks(t);
      else
        estimator.tick(t);
      recorder.stopTimer();
      recorder.accumulate(estimator);
    }
    recorder.writeRow(estimator);
    if (options.progress)
      options.progress((i + 1.0) / outputs);
  }
  // What is left is looked at too: a stray stamp must not go unnoticed.
  takeUntil(std::numeric_limits<double>::infinity(), base, estimator, recording, adapter);
  return warningsOf(recording);
}

}  // namespace tether_monitor
