#include "tether_monitor/ros/bag_replay.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "tether_monitor/ros/bag_recording.h"

namespace tether_monitor
{
namespace
{
constexpr double DEFAULT_RATE = 20.0;  // [Hz]

// As the messages came in, late ones late.
void sortByArrival(BagRecording& recording)
{
  for (BagStream& stream : recording.streams)
    std::stable_sort(stream.inputs.begin(), stream.inputs.end(),
                     [](const BagInput& a, const BagInput& b) { return a.arrival() < b.arrival(); });
}

// Gives the messages of a recording to the estimator, one after the other.
struct Feed
{
  BagRecording& recording;
  InputAdapter& adapter;
  const TimeOrigin& base;
  replay::InputLog& log;

  void acceptNext(InputStream of) const
  {
    BagStream& stream = recording.at(of);
    const BagInput& input = stream.inputs[stream.next++];
    const std::optional<InputError> error = input.message.accept(adapter, input.recorded);
    const std::string& topic = input.source->config.topic;
    log.add(base.seconds(input.arrival()), topic, secondsBetween(input.arrival(), input.stamp), error.has_value());
    if (error)
      recording.refuse(topic, *error);
  }
};

const monitor::MotionBuffer& trackOf(InputStream body, const monitor::TetherEstimator& estimator)
{
  return body == InputStream::VESSEL ? estimator.vessel().track() : estimator.vehicle().track();
}

// Accepts what has arrived by time t.
void acceptArrived(double t, const Feed& feed)
{
  for (const InputStream of : ALL_STREAMS)
  {
    const BagStream& stream = feed.recording.at(of);
    while (stream.hasNext() && feed.base.seconds(stream.inputs[stream.next].arrival()) <= t)
      feed.acceptNext(of);
  }
}

// Accepts what is stamped up to time t, and of each body what comes next, so that its motion is interpolated.
void acceptAhead(double t, const monitor::TetherEstimator& estimator, const Feed& feed)
{
  const double furthest = t + estimator.config().pose_timeout;
  for (const InputStream of : ALL_STREAMS)
  {
    const BagStream& stream = feed.recording.at(of);
    while (stream.hasNext())
    {
      const double stamp = feed.base.seconds(stream.inputs[stream.next].stamp);
      const bool is_enough = of == InputStream::OTHER || trackOf(of, estimator).canInterpolate(t);
      if (stamp > t && (is_enough || stamp > furthest))
        break;
      feed.acceptNext(of);
    }
  }
}

void acceptUntil(double t, const monitor::TetherEstimator& estimator, const Feed& feed)
{
  if (estimator.vehicle().acceptsLateMeasurements())
    acceptArrived(t, feed);
  else
    acceptAhead(t, estimator, feed);
}

// Stamps of the first and the last usable pose of a body: neither zero nor beyond the time of its recording.
std::pair<ros::Time, ros::Time> poseSpan(const BagRecording& recording, InputStream body, double tolerance)
{
  std::pair<ros::Time, ros::Time> span;
  for (const BagInput& input : recording.at(body).inputs)
    if (input.source->topic->is_pose && !input.stamp.isZero() &&
        secondsBetween(input.stamp, input.recorded) <= tolerance)
    {
      if (span.first.isZero())
        span.first = input.stamp;
      span.second = input.stamp;
    }
  return span;
}
// Accepts messages until both bodies are known. @throws std::runtime_error if they never are.
void acceptFirstPoses(const std::string& path, const std::vector<InputStream>& bodies,
                      const monitor::TetherEstimator& estimator, const Feed& feed)
{
  for (const InputStream body : bodies)
  {
    while (feed.recording.at(body).hasNext() && !trackOf(body, estimator).hasPose())
      feed.acceptNext(body);
    if (trackOf(body, estimator).hasPose())
      continue;
    std::string text = "the bag " + path + ": every pose of a body was refused";
    for (const std::string& warning : feed.recording.warnings())
      text += "\n  " + warning;
    throw std::runtime_error(text);
  }
}
}  // namespace

std::vector<std::string> replayBag(const std::string& path, const std::string& ns,
                                   const replay::ReplayOptions& options, monitor::TetherEstimator& estimator,
                                   replay::ResultRecorder& recorder)
{
  BagRecording recording(estimator.config());
  const bool needs_vehicle = estimator.vehicle().needsPoses();
  const bool as_it_arrived = estimator.vehicle().acceptsLateMeasurements();
  recording.read(path, ns, needs_vehicle);
  if (as_it_arrived)
    sortByArrival(recording);
  const double tolerance = estimator.config().pose_timeout;
  const auto vessel = poseSpan(recording, InputStream::VESSEL, tolerance);
  const auto vehicle = poseSpan(recording, InputStream::VEHICLE, tolerance);
  const TimeOrigin base(needs_vehicle ? std::min(vessel.first, vehicle.first) : vessel.first);
  InputAdapter adapter(estimator, recording.transforms);
  adapter.setTimeBase(base);
  const Feed feed{recording, adapter, base, recorder.inputs()};
  estimator.setEpoch(base.epoch());
  recorder.setEpoch(base.epoch());
  double begin = base.seconds(std::max(vessel.first, vehicle.first));
  if (!as_it_arrived)
  {
    acceptFirstPoses(path, bodiesNeeded(needs_vehicle), estimator, feed);
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
      acceptUntil(t, estimator, feed);
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
      return recording.warnings();
    if (options.progress)
      options.progress((i + 1.0) / outputs);
  }
  // What is left is accepted too: a stray stamp must not go unnoticed.
  acceptUntil(std::numeric_limits<double>::infinity(), estimator, feed);
  return recording.warnings();
}

}  // namespace tether_monitor
