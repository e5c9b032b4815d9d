#include "tether_monitor/ros/estimator_runner.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/ros/markers.h"
#include "tether_monitor/ros/message_conversions.h"
#include "tether_monitor/ros/transform_input.h"

namespace tether_monitor
{
namespace
{
constexpr double ALARM_PERIOD = 1.0;        // [s]
constexpr double PARAMETER_PERIOD = 1.0;    // [s]
constexpr double REFUSAL_LOG_PERIOD = 5.0;  // [s]
constexpr std::size_t MOST_EARLY = 2000;

bool isDue(const ros::Time& now, const ros::Time& last, double period)
{
  return secondsBetween(now, last) >= period || now < last;
}
}  // namespace

EstimatorRunner::EstimatorRunner(const monitor::Config& config)
  : estimator_(config),
    adapter_(estimator_, transforms_),
    transform_poses_(config, transforms_),
    statistics_(1.0 / config.rate)
{
  estimator_.setBackgroundStart(true);
}

CycleStatistics EstimatorRunner::statistics()
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  return statistics_;
}

TimeOrigin EstimatorRunner::timeOrigin()
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  return time_;
}

// Nothing that a message or a cycle meets ends the node.
template <typename Work>
bool EstimatorRunner::guarded(const std::string& what, const Work& work)
{
  std::string why = "an unknown exception";
  try
  {
    work();
    return true;
  }
  catch (const std::exception& error)
  {
    why = error.what();
  }
  catch (...)
  {
  }
  RefusalCount& failure = diagnostics_.failures[what];
  ++failure.count;
  failure.last_reason = why;
  ROS_ERROR_THROTTLE(REFUSAL_LOG_PERIOD, "%s failed: %s", what.c_str(), why.c_str());
  return false;
}

void EstimatorRunner::noteRefusal(const std::string& topic, const InputError& why)
{
  RefusalCount& refusal = diagnostics_.refusals[topic];
  ++refusal.count;
  refusal.last_reason = why;
  ROS_WARN_THROTTLE(REFUSAL_LOG_PERIOD, "refused a message on %s: %s", topic.c_str(), why.c_str());
}

void EstimatorRunner::takeMessages(const ros::Time& now)
{
  queue_.drain([this](const ReceivedMessage& received) { takeMessage(received); });
  acceptEarly(now);
  diagnostics_.lost_messages = queue_.lost();
}

void EstimatorRunner::takeMessage(const ReceivedMessage& received)
{
  const ros::Time& now = received.received;
  // Static transforms come once.
  if (now.isZero() && !received.are_static)
    return noteRefusal(received.topic, "simulated time has not begun: nothing on /clock yet");
  if (received.unreadable)
    return noteRefusal(received.topic, *received.unreadable);
  newest_received_ = std::max(newest_received_, received.received_wall);
  guarded(received.topic,
          [&]
          {
            if (!received.source)
            {
              if (const auto error = addTransforms(*received.transforms, received.are_static, now, transforms_))
                noteRefusal(received.topic, *error);
              return;
            }
            ensureTimeBase(now);
            if (!noteStatistics(received))
              return;
            acceptEarly(now);
            const InputMessage& message = received.message;
            const double ahead = message.stamp ? secondsBetween(*message.stamp, now) : 0.0;
            const bool waits = estimator_.vehicle().acceptsLateMeasurements() && ahead > 0.0 &&
                               ahead <= mostOf(Field::FUTURE) && early_.size() < MOST_EARLY;
            if (waits)
              early_.push_back({received.topic, message});
            else
              accept(received.topic, message, now);
          });
}

void EstimatorRunner::accept(const std::string& topic, const InputMessage& message, const ros::Time& now)
{
  if (const std::optional<InputError> error = message.accept(adapter_, now))
    noteRefusal(topic, *error);
}

// In order of their stamps, as a replay has them.
void EstimatorRunner::acceptEarly(const ros::Time& now)
{
  const auto is_due = [&](const EarlyMessage& early) { return *early.message.stamp <= now; };
  const auto later = std::stable_partition(early_.begin(), early_.end(), is_due);
  std::stable_sort(early_.begin(), later,
                   [](const EarlyMessage& a, const EarlyMessage& b)
                   { return *a.message.stamp < *b.message.stamp; });
  for (auto early = early_.begin(); early != later; ++early)
    guarded(early->topic, [&] { accept(early->topic, early->message, now); });
  early_.erase(early_.begin(), later);
}

// Whether the message has a time of its own.
bool EstimatorRunner::noteStatistics(const ReceivedMessage& received)
{
  const InputTopic& topic = *received.source->topic;
  const double t = time_.seconds(received.received);
  const double offset =
      received.message.stamp ? secondsBetween(*received.message.stamp, received.received) : std::nan("");
  InputStatistics& statistics = diagnostics_.statistics[received.topic];
  statistics.add(t, offset, received.message.publisher);
  if (topic.is_pose && statistics.publisherCount(t) > 1)
    estimator_.noteImplausible(
        topic.stream == InputStream::VESSEL ? monitor::Subject::VESSEL : monitor::Subject::VEHICLE,
        monitor::Implausibility::TWO_SOURCES, t);
  return !statistics.isWithoutTime(t, offset);
}

void EstimatorRunner::ensureTimeBase(const ros::Time& now)
{
  if (has_time_base_)
    return;
  has_time_base_ = true;
  if (!restore(now))
    time_ = TimeOrigin(now);
  diagnostics_.time = time_;
  adapter_.setTimeBase(time_);
  estimator_.setEpoch(time_.epoch());
}

// What is older than the tether's memory keeps its alarms alone.
bool EstimatorRunner::restore(const ros::Time& now)
{
  if (!kept_)
    return false;
  const KeptState state = std::move(*kept_);
  kept_.reset();
  if (!estimator_.restore(state.bytes))
  {
    ROS_WARN("the kept state is of another configuration or version: beginning anew");
    return false;
  }
  last_event_ = estimator_.alarms().log().last();
  const double age = state.time.seconds(now) - estimator_.estimate().time;
  const bool is_young = age >= 0.0 && age < std::min(estimator_.memory(), config().invalid_timeout);
  if (!is_young)
    estimator_.reset();
  ROS_INFO("kept state of %.1f s ago: %s", age, is_young ? "going on from it" : "its alarms only");
  time_ = state.time;
  return true;
}

visualization_msgs::MarkerArray EstimatorRunner::picture(const std_msgs::Header& header)
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  return markers(header, estimator_, adapter_.fixes());
}

std::optional<KeptState> EstimatorRunner::keep()
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  if (!has_time_base_)
    return std::nullopt;
  return KeptState{time_, estimator_.save()};
}

// Where time is simulated a cycle that was missed shows in the time that has passed.
void EstimatorRunner::noteCycle(const ros::Time& now, double lateness)
{
  const double since_last = secondsBetween(now, last_cycle_), period = 1.0 / config().rate;
  if (!last_cycle_.isZero() && since_last > 0.0)
    statistics_.add(std::max(lateness, ros::Time::isSimTime() ? since_last - period : 0.0));
  last_cycle_ = now;
}

bool EstimatorRunner::cycle(const ros::Time& now, double lateness, CycleOutput& output)
{
  const std::lock_guard<PriorityMutex> lock(mutex_);
  if (now.isZero() || now == last_cycle_)
    return false;
  const ros::WallTime began = ros::WallTime::now();
  if (!guarded("a cycle", [&] { step(now); }))
    guarded("a reset", [&] { estimator_.reset(); });  // what is left of it may be anything
  noteCycle(now, lateness);
  const double step_time = (ros::WallTime::now() - began).toSec();
  diagnostics_.worst_step_time = std::max(diagnostics_.worst_step_time, step_time);
  return guarded("an output", [&] { describe(now, step_time, output); });
}

void EstimatorRunner::step(const ros::Time& now)
{
  ensureTimeBase(now);
  takeMessages(now);
  transform_poses_.read(adapter_, now,
                        [this](const std::string& frame, const InputError& error) { noteRefusal(frame, error); });
  monitor::ShellReport report;
  report.forecast_probability = diagnostics_.forecast_probability;
  report.resonance = nearnessOfResonance(diagnostics_.vibration);
  report.missed_cycles = statistics_.lateShare();
  estimator_.report(report);
  const monitor::Status before = estimator_.estimate().status;
  const monitor::Reason reason_before = estimator_.estimate().reason;
  const monitor::TetherEstimate& e = estimator_.tick(time_.seconds(now));
  if (e.reason == monitor::Reason::CLOCK_JUMP && now < last_cycle_)
  {
    transforms_.clear();
    transform_poses_.clear();
    early_.clear();
    adapter_.clearFixes();
    diagnostics_.statistics.clear();
    last_alarms_ = ros::Time();
  }
  if (e.status != before || e.reason != reason_before)
    ROS_INFO("%s%s%s", monitor::describe(e.status), e.reason == monitor::Reason::NONE ? "" : ": ",
             e.reason == monitor::Reason::NONE ? "" : advice(e.reason));
}

void EstimatorRunner::describe(const ros::Time& now, double step_time, CycleOutput& output)
{
  const monitor::TetherEstimate& e = estimator_.estimate();
  output.stamp = now;
  output.time = time_;
  output.step_time = step_time;
  output.over_tension = estimator_.overTension();
  output.estimate = e;
  output.received = newest_received_;
  newest_received_ = ros::WallTime();

  output.alarms.reset();
  const long last_event = estimator_.alarms().log().last();
  if (last_event != last_event_ || isDue(now, last_alarms_, ALARM_PERIOD))
  {
    output.alarms = std::make_shared<const monitor::AlarmSet>(estimator_.alarms());
    last_event_ = last_event;
    last_alarms_ = now;
  }

  output.attitude.reset();
  if (e.has_vehicle)
    output.attitude = e.vehicle.orientation;
  else if (estimator_.vehicle().track().hasPose())
    output.attitude = estimator_.vehicle().track().lastOrientation();

  output.vessel.reset();
  if (config().runtime.outputs.vessel_pose)
  {
    output.vessel = estimator_.vessel().bodyAt(e.time);
    output.vessel_stddev = estimator_.vessel().positionStddev(e.time);
  }

  // While something is touched, and once when nothing is any more.
  output.contacts.reset();
  ContactArray contacts = contactsMessage(e, estimator_.simulation().model.environment().obstacles());
  const bool has_contact = !contacts.contacts.empty();
  if (has_contact || had_contact_)
  {
    contacts.header.stamp = now;
    contacts.header.frame_id = config().world_frame;
    output.contacts = std::move(contacts);
  }
  had_contact_ = has_contact;

  output.parameters.reset();
  if (!estimator_.vehicle().ensemble() || !e.has_stations || !isDue(now, last_parameters_, PARAMETER_PERIOD))
    return;
  last_parameters_ = now;
  std_msgs::Header header;
  header.stamp = now;
  header.frame_id = config().world_frame;
  output.parameters = toMessage(header, estimator_.parameters());
}

}  // namespace tether_monitor
