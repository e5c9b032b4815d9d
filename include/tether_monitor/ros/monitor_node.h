#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tether_monitor/AlarmAction.h>
#include <tether_monitor/AlarmLog.h>

#include <string>
#include <vector>

#include "tether_monitor/ros/cycle_thread.h"
#include "tether_monitor/ros/estimator_runner.h"
#include "tether_monitor/ros/forecast_publisher.h"
#include "tether_monitor/ros/live_settings_server.h"
#include "tether_monitor/ros/master_watch.h"
#include "tether_monitor/ros/output_publisher.h"
#include "tether_monitor/ros/publishing_thread.h"
#include "tether_monitor/ros/state_keeper.h"

namespace tether_monitor
{
/**
 * The ROS side of the monitor of one tether: subscribes, runs the cycles, publishes.
 *
 * **Subscribes** (relative): inputTopics(). **Publishes**: OutputPublisher, ForecastPublisher, /diagnostics.
 * **Services** (private): reset, acknowledge, alarm_action, alarm_log; LiveSettingsServer. Threads: callbacks (the
 * caller's), cycles (CycleThread), publishing (PublishingThread), forecasts (ForecastThread), the state file
 * (StateKeeper).
 */
class MonitorNode
{
 public:
  /**
   * @param nh          for inputs.
   * @param private_nh  for parameters, outputs and services.
   * @throws params::ParameterError listing every fault of the parameters; std::runtime_error if the state file
   * cannot be written.
   */
  MonitorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  void subscribe();
  void subscribeTo(const InputSource& source);
  void subscribeToTransforms(const std::string& topic, bool is_static);
  void advertiseServices();
  void addDiagnostics();
  std::vector<std::string> reconfigure(const monitor::Config& config);
  void cycle(double lateness);
  visualization_msgs::MarkerArray picture(const std_msgs::Header& header);
  void updateVibration();
  void updateSurroundings();
  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool acknowledge(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool actOnAlarm(AlarmAction::Request& request, AlarmAction::Response& response);
  bool listEvents(AlarmLog::Request& request, AlarmLog::Response& response);

  ros::NodeHandle nh_, private_nh_;
  EstimatorRunner runner_;
  StateKeeper keeper_;
  long kept_event_ = 0;
  ros::Time last_seen_clock_;
  diagnostic_updater::Updater updater_;
  MasterWatch master_watch_;
  std::vector<InputSource> sources_;
  std::vector<ros::Subscriber> subscribers_;
  std::vector<ros::ServiceServer> services_;
  ros::Timer tick_timer_;
  ros::WallTimer diagnostics_timer_;
  ros::WallTime last_vibration_, last_reset_;
  ForecastPublisher forecast_;  // outlives what draws it
  OutputPublisher publisher_;
  PublishingThread publishing_;
  CycleThread cycles_;
  LiveSettingsServer settings_;
};

}  // namespace tether_monitor
