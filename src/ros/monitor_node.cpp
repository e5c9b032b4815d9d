#include "tether_monitor/ros/monitor_node.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/monitor/config/suspicious_values.h"
#include "tether_monitor/params/load_config.h"
#include "tether_monitor/ros/attachment_frames.h"
#include "tether_monitor/ros/markers.h"
#include "tether_monitor/ros/parameter_server.h"

namespace tether_monitor
{
namespace
{
constexpr double DIAGNOSTIC_PERIOD = 1.0;  // [s], wall clock: diagnostics also tell of a clock that stands still
constexpr double VIBRATION_PERIOD = 10.0;  // [s], wall clock: natural modes take milliseconds
constexpr double SHORTEST_RESET_INTERVAL = 1.0;  // [s], wall clock: a start takes some time
constexpr int BODY_QUEUE = 100, OTHER_QUEUE = 5, TRANSFORM_QUEUE = 100;  // messages that wait

std::vector<InputSource> sourcesOf(const monitor::Config& config, const std::string& where)
{
  try
  {
    return inputSources(config.inputs);
  }
  catch (const std::invalid_argument& error)
  {
    throw params::ParameterError(where, {error.what()});
  }
}
}  // namespace

MonitorNode::MonitorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh)
  : nh_(nh),
    private_nh_(private_nh),
    runner_(params::loadConfig(withPlacedAttachments(readParameterServer(private_nh), private_nh),
                               private_nh.getNamespace())),
    keeper_(runner_.config().runtime.state_file),
    updater_(nh, private_nh, private_nh.getNamespace()),
    forecast_(private_nh, runner_.config()),
    publisher_(nh, private_nh, runner_.config(), runner_.config().vehicle_mode == monitor::VehicleMode::OBSERVED,
               runner_.config().vehicle_mode != monitor::VehicleMode::TRACKED,
               [this](const std_msgs::Header& header) { return picture(header); }),
    publishing_(publisher_),
    cycles_(1.0 / runner_.config().rate, ros::Time::isSimTime(), runner_.config().runtime,
            [this](double lateness) { cycle(lateness); }),
    settings_(private_nh, runner_.config(), [this](const monitor::Config& wanted) { return reconfigure(wanted); })
{
  const monitor::Config& config = runner_.config();
  sources_ = sourcesOf(config, private_nh.getNamespace());
  if (std::optional<KeptState> kept = keeper_.read())
    runner_.adopt(std::move(*kept));
  advertiseServices();
  addDiagnostics();
  subscribe();
  if (ros::Time::isSimTime())
    tick_timer_ =
        nh_.createTimer(ros::Duration(1.0 / config.rate), [this](const ros::TimerEvent&) { cycles_.notify(); });
  cycles_.start();
  for (const std::string& value : monitor::suspiciousValues(config))
    ROS_WARN("suspicious: %s", value.c_str());
  if (!cycles_.refusal().empty())
    ROS_WARN("monitor.realtime: %s; going on without", cycles_.refusal().c_str());
  const std::string elements =
      config.accuracy ? "as many elements as it needs" : std::to_string(config.elements) + " elements";
  ROS_INFO("%s watches a tether of %g m in %s at %g Hz in frame '%s'", private_nh_.getNamespace().c_str(),
           config.tether.length, elements.c_str(), config.rate, config.world_frame.c_str());
}

void MonitorNode::subscribe()
{
  for (const InputSource& source : sources_)
    subscribeTo(source);
  subscribeToTransforms("/tf", false);
  subscribeToTransforms("/tf_static", true);
}

// Of any type: what is published decides.
void MonitorNode::subscribeTo(const InputSource& source)
{
  using Event = ros::MessageEvent<const topic_tools::ShapeShifter>;
  const boost::function<void(const Event&)> receive = [this, &source](const Event& event)
  {
    ReceivedMessage received;
    received.topic = source.config.topic;
    received.unreadable = source.read(*event.getConstMessage(), event.getPublisherName(), received.message);
    received.source = received.unreadable ? nullptr : &source;
    received.received = ros::Time::now();
    received.received_wall = ros::WallTime::now();
    runner_.receive(received);
  };
  ros::SubscribeOptions options;
  // What is large and rare must not pile up.
  const int queue = source.topic->stream == InputStream::OTHER ? OTHER_QUEUE : BODY_QUEUE;
  options.initByFullCallbackType<const Event&>(source.published(), queue, receive);
  options.transport_hints = ros::TransportHints().tcpNoDelay();
  subscribers_.push_back(nh_.subscribe(options));
}

void MonitorNode::subscribeToTransforms(const std::string& topic, bool is_static)
{
  const boost::function<void(const tf2_msgs::TFMessageConstPtr&)> receive =
      [this, is_static](const tf2_msgs::TFMessageConstPtr& message)
  {
    ReceivedMessage received;
    received.topic = is_static ? "/tf_static" : "/tf";
    received.transforms = message;
    received.are_static = is_static;
    received.received = ros::Time::now();
    runner_.receive(received);
  };
  subscribers_.push_back(nh_.subscribe<tf2_msgs::TFMessage>(topic, TRANSFORM_QUEUE, receive));
}

void MonitorNode::advertiseServices()
{
  services_.push_back(private_nh_.advertiseService("reset", &MonitorNode::reset, this));
  services_.push_back(private_nh_.advertiseService("acknowledge", &MonitorNode::acknowledge, this));
  services_.push_back(private_nh_.advertiseService("alarm_action", &MonitorNode::actOnAlarm, this));
  services_.push_back(private_nh_.advertiseService("alarm_log", &MonitorNode::listEvents, this));
}

void MonitorNode::addDiagnostics()
{
  updater_.setHardwareID(private_nh_.getNamespace());
  using Status = diagnostic_updater::DiagnosticStatusWrapper;
  updater_.add("tether",
               [this](Status& status)
               {
                 runner_.access([&](const monitor::TetherEstimator& estimator, const DiagnosticInputs& inputs)
                                { diagnose(estimator, inputs, status); });
               });
  updater_.add("vibration",
               [this](Status& status)
               {
                 runner_.access([&](const monitor::TetherEstimator&, const DiagnosticInputs& inputs)
                                { diagnoseVibration(inputs.vibration, status); });
               });
  updater_.add("timing",
               [this](Status& status)
               {
                 const DiagnosticInputs inputs = runner_.access(
                     [](const monitor::TetherEstimator&, const DiagnosticInputs& now) { return now; });
                 diagnoseTiming(inputs, runner_.statistics(), publishing_.report(), status);
               });
  diagnostics_timer_ = nh_.createWallTimer(ros::WallDuration(DIAGNOSTIC_PERIOD),
                                           [this](const ros::WallTimerEvent&)
                                           {
                                             updateVibration();
                                             updateSurroundings();
                                             updater_.force_update();
                                           });
}

std::vector<std::string> MonitorNode::reconfigure(const monitor::Config& config)
{
  const std::vector<std::string> problems = runner_.access(
      [&](monitor::TetherEstimator& estimator, const DiagnosticInputs&) { return estimator.reconfigure(config); });
  if (problems.empty())
    forecast_.reconfigure(config);
  return problems;
}

visualization_msgs::MarkerArray MonitorNode::picture(const std_msgs::Header& header)
{
  visualization_msgs::MarkerArray picture = runner_.picture(header);
  picture.markers.push_back(forecastLine(header, forecast_.position(header.stamp)));
  return picture;
}

void MonitorNode::cycle(double lateness)
{
  const ros::Time now = ros::Time::now();
  CycleOutput& output = publishing_.next();
  if (!runner_.cycle(now, lateness, output))
    return;
  const double t = output.estimate.time;
  const long last_event = output.alarms ? output.alarms->log().last() : kept_event_;
  publishing_.submit();
  runner_.access(
      [&](const monitor::TetherEstimator& estimator, DiagnosticInputs& inputs)
      {
        forecast_.offer(estimator, inputs.time);
        inputs.forecast_probability = forecast_.probability(t);
      });
  if (!keeper_.isDue(t) && last_event == kept_event_)
    return;
  kept_event_ = last_event;
  if (!keeper_.isOn())
    return;
  if (std::optional<KeptState> state = runner_.keep())
    keeper_.submit(t, std::move(*state));
}

// The modes are found while the cycles go on.
void MonitorNode::updateVibration()
{
  const ros::WallTime now = ros::WallTime::now();
  if ((now - last_vibration_).toSec() < VIBRATION_PERIOD)
    return;
  struct Tether
  {
    core::CableModel model;
    core::CableState state;
    core::VortexShedding shedding;
  };
  const auto tether = runner_.access(
      [](const monitor::TetherEstimator& estimator, const DiagnosticInputs&) -> std::optional<Tether>
      {
        if (!estimator.isRunning() || !estimator.estimate().has_stations)
          return std::nullopt;
        return Tether{estimator.simulation().model, estimator.simulation().state, estimator.vortexShedding()};
      });
  monitor::VibrationReport report;
  if (tether)
    report = monitor::reportVibration(tether->model, tether->state, tether->shedding);
  if (!report.modes.empty())
    last_vibration_ = now;
  runner_.access([&](const monitor::TetherEstimator&, DiagnosticInputs& inputs) { inputs.vibration = report; });
}

void MonitorNode::updateSurroundings()
{
  const ros::Time now = ros::Time::now();
  const ForecastBudget budget = forecast_.budget();
  const bool master_is_lost = master_watch_.isLost();
  const std::string problem = keeper_.problem();
  runner_.access(
      [&](const monitor::TetherEstimator& estimator, DiagnosticInputs& inputs)
      {
        inputs.clock_stands = now == last_seen_clock_;
        inputs.master_is_lost = master_is_lost;
        inputs.forecast_members = estimator.config().forecast.rate > 0.0 ? budget.members() : 0;
        inputs.forecast_interval = budget.interval();
        inputs.forecast_is_short = budget.isShort();
        inputs.realtime_refusal = cycles_.refusal();
        inputs.state_file_problem = problem;
      });
  last_seen_clock_ = now;
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
  runner_.access([](monitor::TetherEstimator& estimator, const DiagnosticInputs&) { estimator.reset(); });
  response.success = true;
  response.message = "motion and measurements forgotten; settling anew at the next poses";
  ROS_INFO("reset: %s", response.message.c_str());
  return true;
}

bool MonitorNode::acknowledge(std_srvs::Trigger::Request&, std_srvs::Trigger::Response& response)
{
  const int changed = runner_.access([](monitor::TetherEstimator& estimator, const DiagnosticInputs&)
                                     { return estimator.acknowledge(); });
  response.success = true;
  response.message = std::to_string(changed) + " alarm(s) acknowledged";
  ROS_INFO("acknowledge: %s", response.message.c_str());
  return true;
}

bool MonitorNode::actOnAlarm(AlarmAction::Request& request, AlarmAction::Response& response)
{
  const std::optional<monitor::AlarmAction> action = monitor::alarmAction(request.action);
  response.message =
      action
          ? runner_.access([&](monitor::TetherEstimator& estimator, const DiagnosticInputs&)
                           { return estimator.actOnAlarm(request.name, *action, request.seconds); })
          : "action '" + request.action +
                "' (must be acknowledge, reset, shelve, unshelve, suppress_by_design, out_of_service or return)";
  response.success = response.message.empty();
  ROS_INFO("alarm_action: %s %s%s%s", request.action.c_str(), request.name.c_str(),
           response.success ? "" : ": refused, ", response.message.c_str());
  return true;
}

bool MonitorNode::listEvents(AlarmLog::Request& request, AlarmLog::Response& response)
{
  const monitor::AlarmSet alarms = runner_.access(
      [](const monitor::TetherEstimator& estimator, const DiagnosticInputs&) { return estimator.alarms(); });
  const TimeOrigin time = runner_.timeOrigin();
  const auto& events = alarms.log().events();
  for (std::size_t i = 0; i < events.size(); ++i)
    if (events[i].number > static_cast<long>(request.after))
      response.events.push_back(toMessage(events[i], alarms, time));
  return true;
}

}  // namespace tether_monitor
