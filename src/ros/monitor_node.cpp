#include "tether_monitor/ros/monitor_node.h"

#include <std_msgs/Bool.h>
#include <visualization_msgs/MarkerArray.h>

#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/config/suspicious_values.h"
#include "tether_monitor/params/load_config.h"
#include "tether_monitor/ros/input_topics.h"
#include "tether_monitor/ros/markers.h"
#include "tether_monitor/ros/message_conversions.h"
#include "tether_monitor/ros/parameter_server.h"
#include "tether_monitor/ros/transform_input.h"

namespace tether_monitor
{
namespace
{
constexpr double ALARM_PERIOD = 1.0;        // [s]
constexpr double PARAMETER_PERIOD = 1.0;    // [s]
constexpr double DIAGNOSTIC_PERIOD = 1.0;   // [s], wall clock: diagnostics also tell of a clock that stands still
constexpr double VIBRATION_PERIOD = 10.0;   // [s], wall clock: natural modes take milliseconds
constexpr double REFUSAL_LOG_PERIOD = 5.0;  // [s]
constexpr double SHORTEST_RESET_INTERVAL = 1.0;  // [s], wall clock: a start takes some time
constexpr int TRANSFORM_QUEUE = 100;
constexpr std::size_t MOST_EARLY = 2000;
constexpr int OUTPUT_QUEUE = 10;
}  // namespace

MonitorNode::MonitorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
  : nh_(nh),
    private_nh_(private_nh),
    estimator_(params::loadConfig(readParameterServer(private_nh), private_nh.getNamespace())),
    adapter_(estimator_, transforms_),
    updater_(nh, private_nh, private_nh.getNamespace()),
    forecast_(private_nh, estimator_.config())
{
  estimator_.setBackgroundStart(true);
  const monitor::Config& config = estimator_.config();
  state_pub_ = private_nh_.advertise<TetherState>("state", OUTPUT_QUEUE);
  vessel_force_pub_ = private_nh_.advertise<geometry_msgs::WrenchStamped>("vessel_end/force", OUTPUT_QUEUE);
  vehicle_force_pub_ = private_nh_.advertise<geometry_msgs::WrenchStamped>("vehicle_end/force", OUTPUT_QUEUE);
  over_tension_pub_ = private_nh_.advertise<std_msgs::Bool>("over_tension", OUTPUT_QUEUE);
  alarms_pub_ = private_nh_.advertise<AlarmArray>("alarms", OUTPUT_QUEUE, true);
  markers_pub_ = private_nh_.advertise<visualization_msgs::MarkerArray>("markers", OUTPUT_QUEUE);
  contacts_pub_ = private_nh_.advertise<ContactArray>("contacts", OUTPUT_QUEUE);
  if (estimator_.vehicle().ensemble())
    parameters_pub_ = private_nh_.advertise<ParameterEstimate>("parameters", OUTPUT_QUEUE);
  if (estimator_.vehicle().takesThrust())
    vehicle_pub_ = private_nh_.advertise<nav_msgs::Odometry>("vehicle/estimate", OUTPUT_QUEUE);
  reset_server_ = private_nh_.advertiseService("reset", &MonitorNode::reset, this);
  acknowledge_server_ = private_nh_.advertiseService("acknowledge", &MonitorNode::acknowledge, this);

  updater_.setHardwareID(private_nh_.getNamespace());
  updater_.add("tether", [this](diagnostic_updater::DiagnosticStatusWrapper& status)
               { diagnose(estimator_, diagnostic_inputs_, status); });
  updater_.add("vibration", [this](diagnostic_updater::DiagnosticStatusWrapper& status)
               { diagnoseVibration(diagnostic_inputs_.vibration, status); });

  for (const InputTopic& topic : inputTopics())
    subscribers_.push_back(
        topic.subscribe(nh_, [this, &topic](const InputMessage& message) { receive(topic, message); }));
  subscribeToTransforms("/tf", false);
  subscribeToTransforms("/tf_static", true);

  tick_timer_ = nh_.createTimer(ros::Duration(1.0 / config.rate), [this](const ros::TimerEvent&) { tick(); });
  diagnostics_timer_ = nh_.createWallTimer(ros::WallDuration(DIAGNOSTIC_PERIOD),
                                           [this](const ros::WallTimerEvent&)
                                           {
                                             updateVibration();
                                             updateSurroundings();
                                             updater_.force_update();
                                           });
  for (const std::string& value : monitor::suspiciousValues(config))
    ROS_WARN("suspicious: %s", value.c_str());
  const std::string elements =
      config.accuracy ? "as many elements as it needs" : std::to_string(config.elements) + " elements";
  ROS_INFO("%s watches a tether of %g m in %s at %g Hz in frame '%s'", private_nh_.getNamespace().c_str(),
           config.tether.length, elements.c_str(), config.rate, config.world_frame.c_str());
}

// Nothing that a message or a cycle meets ends the node.
template <typename Work>
bool MonitorNode::guarded(const std::string& what, const Work& work)
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
  RefusalCount& failure = diagnostic_inputs_.failures[what];
  ++failure.count;
  failure.last_reason = why;
  ROS_ERROR_THROTTLE(REFUSAL_LOG_PERIOD, "%s failed: %s", what.c_str(), why.c_str());
  return false;
}

void MonitorNode::subscribeToTransforms(const std::string& topic, bool is_static)
{
  const boost::function<void(const tf2_msgs::TFMessage&)> receive =
      [this, topic, is_static](const tf2_msgs::TFMessage& message)
  {
    guarded(topic,
            [&]
            {
              if (const auto error = addTransforms(message, is_static, ros::Time::now(), transforms_))
                noteRefusal(topic, *error);
            });
  };
  subscribers_.push_back(nh_.subscribe<tf2_msgs::TFMessage>(topic, TRANSFORM_QUEUE, receive));
}

void MonitorNode::receive(const InputTopic& topic, const InputMessage& message)
{
  const ros::Time now = ros::Time::now();
  if (now.isZero())
    return noteRefusal(topic.name, "simulated time has not begun: nothing on /clock yet");
  guarded(topic.name,
          [&]
          {
            ensureTimeBase(now);
            noteStatistics(topic, message, now);
            acceptEarly(now);
            const double ahead = message.stamp ? secondsBetween(*message.stamp, now) : 0.0;
            const bool waits = estimator_.vehicle().acceptsLateMeasurements() && ahead > 0.0 &&
                               ahead <= mostOf(Field::FUTURE) && early_.size() < MOST_EARLY;
            if (waits)
              early_.push_back({&topic, message});
            else
              accept(topic, message, now);
          });
}

void MonitorNode::accept(const InputTopic& topic, const InputMessage& message, const ros::Time& now)
{
  if (const std::optional<InputError> error = message.accept(adapter_, now))
    noteRefusal(topic.name, *error);
}

// In order of their stamps, as a replay has them.
void MonitorNode::acceptEarly(const ros::Time& now)
{
  const auto isDue = [&](const EarlyMessage& early) { return *early.message.stamp <= now; };
  const auto later = std::stable_partition(early_.begin(), early_.end(), isDue);
  std::stable_sort(early_.begin(), later,
                   [](const EarlyMessage& a, const EarlyMessage& b)
                   { return *a.message.stamp < *b.message.stamp; });
  for (auto early = early_.begin(); early != later; ++early)
    guarded(early->topic->name, [&] { accept(*early->topic, early->message, now); });
  early_.erase(early_.begin(), later);
}

void MonitorNode::noteStatistics(const InputTopic& topic, const InputMessage& message, const ros::Time& now)
{
  const double offset = message.stamp ? secondsBetween(*message.stamp, now) : std::nan(""), t = time_.seconds(now);
  InputStatistics& statistics = diagnostic_inputs_.statistics[topic.name];
  statistics.add(t, offset, message.publisher);
  if (topic.is_pose && statistics.publisherCount(t) > 1)
    estimator_.noteImplausible(
        topic.stream == InputStream::VESSEL ? monitor::Subject::VESSEL : monitor::Subject::VEHICLE,
        monitor::Implausibility::TWO_SOURCES, t);
}

void MonitorNode::noteRefusal(const std::string& topic, const InputError& why)
{
  RefusalCount& refusal = diagnostic_inputs_.refusals[topic];
  ++refusal.count;
  refusal.last_reason = why;
  ROS_WARN_THROTTLE(REFUSAL_LOG_PERIOD, "refused a message on %s: %s", topic.c_str(), why.c_str());
}

void MonitorNode::ensureTimeBase(const ros::Time& now)
{
  if (has_time_base_)
    return;
  has_time_base_ = true;
  time_ = TimeOrigin(now);
  diagnostic_inputs_.time = time_;
  adapter_.setTimeBase(time_);
  estimator_.setEpoch(time_.epoch());
}

void MonitorNode::tick()
{
  const ros::Time now = ros::Time::now();
  if (now.isZero() || now == last_tick_)
    return;
  if (guarded("a cycle", [&] { step(now); }))
    return;
  // What is left of it may be anything: better no estimate than that.
  guarded("a reset", [&] { estimator_.reset(); });
  guarded("publishing", [&] { publish(now, 0.0); });
}

void MonitorNode::step(const ros::Time& now)
{
  ensureTimeBase(now);
  acceptEarly(now);
  const ros::WallTime began = ros::WallTime::now();
  const monitor::Status before = estimator_.estimate().status;
  const monitor::Reason reason_before = estimator_.estimate().reason;
  const monitor::TetherEstimate& e = estimator_.tick(time_.seconds(now));
  if (e.reason == monitor::Reason::CLOCK_JUMP && now < last_tick_)
  {
    transforms_.clear();
    early_.clear();
    diagnostic_inputs_.statistics.clear();
    last_alarms_ = ros::Time();
  }
  const double since_last = secondsBetween(now, last_tick_);
  if (!last_tick_.isZero() && since_last > 0.0)
    diagnostic_inputs_.missed += std::max(0L, std::lround(since_last * estimator_.config().rate) - 1);
  last_tick_ = now;
  const double step_time = (ros::WallTime::now() - began).toSec();
  diagnostic_inputs_.worst_step_time = std::max(diagnostic_inputs_.worst_step_time, step_time);
  ++diagnostic_inputs_.ticks;
  if (e.status != before || e.reason != reason_before)
    ROS_INFO("%s%s%s", describe(e.status), e.reason == monitor::Reason::NONE ? "" : ": ",
             e.reason == monitor::Reason::NONE ? "" : advice(e.reason));
  publish(now, step_time);
  forecast_.offer(estimator_, time_);
}

void MonitorNode::publish(const ros::Time& stamp, double step_time)
{
  const monitor::TetherEstimate& e = estimator_.estimate();
  std_msgs::Header header;
  header.stamp = stamp;
  header.frame_id = estimator_.config().world_frame;

  // The word that a control loop waits for goes first.
  std_msgs::Bool over_tension;
  over_tension.data = estimator_.overTension();
  over_tension_pub_.publish(over_tension);

  toMessage(e, state_message_);
  state_message_.header = header;
  state_message_.step_time = step_time;
  state_pub_.publish(state_message_);
  vessel_force_pub_.publish(wrenchMessage(header, e, e.stations.ends.vessel, e.stations.ends.vessel_moment));
  vehicle_force_pub_.publish(wrenchMessage(header, e, e.stations.ends.vehicle, e.stations.ends.vehicle_moment));
  publishVehicle(header);
  publishContacts(header);
  publishParameters(header);
  const bool due = secondsBetween(stamp, last_alarms_) >= ALARM_PERIOD || stamp < last_alarms_;
  if (estimator_.alarmsChanged() || acknowledged_ || due)
    publishAlarms(header);
  if (markers_pub_.getNumSubscribers() > 0)
    markers_pub_.publish(markers(header, estimator_));
}

void MonitorNode::publishVehicle(const std_msgs::Header& header)
{
  const monitor::TetherEstimate& e = estimator_.estimate();
  const monitor::BodyConfig& body = estimator_.config().vehicle;
  if (e.has_vehicle)
    vehicle_pub_.publish(vehicleMessage(header, body, e));
}

void MonitorNode::publishParameters(const std_msgs::Header& header)
{
  const double since_last = secondsBetween(header.stamp, last_parameters_);
  if (!parameters_pub_ || !estimator_.estimate().has_stations ||
      (since_last >= 0.0 && since_last < PARAMETER_PERIOD))
    return;
  last_parameters_ = header.stamp;
  parameters_pub_.publish(toMessage(header, estimator_.parameters()));
}

// While something is touched, and once when nothing is any more.
void MonitorNode::publishContacts(const std_msgs::Header& header)
{
  ContactArray contacts =
      contactsMessage(estimator_.estimate(), estimator_.simulation().model.environment().obstacles());
  const bool has_contact = !contacts.contacts.empty();
  if (!has_contact && !had_contact_)
    return;
  had_contact_ = has_contact;
  contacts.header = header;
  contacts_pub_.publish(contacts);
}

void MonitorNode::updateVibration()
{
  const ros::WallTime now = ros::WallTime::now();
  if ((now - last_vibration_).toSec() < VIBRATION_PERIOD)
    return;
  if (!estimator_.isRunning() || !estimator_.estimate().has_stations)
  {
    diagnostic_inputs_.vibration = monitor::VibrationReport();
    return;
  }
  diagnostic_inputs_.vibration = monitor::reportVibration(
      estimator_.simulation().model, estimator_.simulation().state, estimator_.vortexShedding());
  if (!diagnostic_inputs_.vibration.modes.empty())
    last_vibration_ = now;
}

void MonitorNode::updateSurroundings()
{
  const ros::Time now = ros::Time::now();
  diagnostic_inputs_.clock_stands = now == last_seen_clock_;
  last_seen_clock_ = now;
  diagnostic_inputs_.master_is_lost = master_watch_.isLost();
  const ForecastBudget budget = forecast_.budget();
  diagnostic_inputs_.forecast_members = estimator_.config().forecast.rate > 0.0 ? budget.members() : 0;
  diagnostic_inputs_.forecast_interval = budget.interval();
  diagnostic_inputs_.forecast_is_short = budget.isShort();
}

void MonitorNode::publishAlarms(const std_msgs::Header& header)
{
  AlarmArray array = toMessage(estimator_.alarms(), time_);
  array.header = header;
  alarms_pub_.publish(array);
  last_alarms_ = header.stamp;
  acknowledged_ = false;
}

bool MonitorNode::reset(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  const ros::WallTime now = ros::WallTime::now();
  if ((now - last_reset_).toSec() < SHORTEST_RESET_INTERVAL)
  {
    response.success = false;
    response.message = "refused: the last reset was less than a second ago";
    return true;
  }
  last_reset_ = now;
  estimator_.reset();
  response.success = true;
  response.message = "motion and measurements forgotten; settling anew at the next poses";
  ROS_INFO("reset: %s", response.message.c_str());
  return true;
}

bool MonitorNode::acknowledge(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  const int changed = estimator_.acknowledge();
  acknowledged_ = true;
  response.success = true;
  response.message = std::to_string(changed) + " alarm(s) acknowledged";
  ROS_INFO("acknowledge: %s", response.message.c_str());
  return true;
}

}  // namespace tether_monitor
