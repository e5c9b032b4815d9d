#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/ros.h>
#include <std_srvs/Trigger.h>
#include <tether_monitor/TetherState.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <string>
#include <vector>

#include "tether_monitor/monitor/estimator/tether_estimator.h"
#include "tether_monitor/ros/diagnostics.h"
#include "tether_monitor/ros/forecast_publisher.h"
#include "tether_monitor/ros/input_adapter.h"
#include "tether_monitor/ros/input_topics.h"
#include "tether_monitor/ros/master_watch.h"

namespace tether_monitor
{
/**
 * The ROS side of the monitor of one tether: subscribes, ticks, publishes.
 *
 * **Subscribes** (relative): inputTopics(). **Publishes** (private): state,
 * vessel_end/force, vehicle_end/force, over_tension, alarms, vehicle/estimate, contacts, markers; /diagnostics.
 * Forecasts: ForecastPublisher. **Services** (private): reset, acknowledge.
 */
class MonitorNode
{
 public:
  /**
   * @param nh          for inputs.
   * @param private_nh  for parameters, outputs and services.
   * @throws params::ParameterError listing every fault of the parameters.
   */
  MonitorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

 private:
  void subscribeToTransforms(const std::string& topic, bool is_static);
  void receive(const InputTopic& topic, const InputMessage& message);
  void accept(const InputTopic& topic, const InputMessage& message, const ros::Time& now);
  void acceptEarly(const ros::Time& now);
  void noteStatistics(const InputTopic& topic, const InputMessage& message, const ros::Time& now);
  template <typename Work>
  bool guarded(const std::string& what, const Work& work);
  void noteRefusal(const std::string& topic, const InputError& why);
  void ensureTimeBase(const ros::Time& now);
  void tick();
  void step(const ros::Time& now);
  void publish(const ros::Time& stamp, double step_time);
  void publishVehicle(const std_msgs::Header& header);
  void publishParameters(const std_msgs::Header& header);
  void publishContacts(const std_msgs::Header& header);
  void updateVibration();
  void updateSurroundings();
  void publishAlarms(const std_msgs::Header& header);
  bool reset(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);
  bool acknowledge(std_srvs::Trigger::Request& request, std_srvs::Trigger::Response& response);

  ros::NodeHandle nh_, private_nh_;
  monitor::TetherEstimator estimator_;
  tf2::BufferCore transforms_;
  InputAdapter adapter_;
  TimeOrigin time_;
  bool has_time_base_ = false;
  ros::Time last_tick_, last_alarms_, last_parameters_, last_seen_clock_;
  bool acknowledged_ = false;
  TetherState state_message_;
  DiagnosticInputs diagnostic_inputs_;
  diagnostic_updater::Updater updater_;
  MasterWatch master_watch_;

  struct EarlyMessage
  {
    const InputTopic* topic;
    InputMessage message;
  };
  std::vector<EarlyMessage> early_;  // stamped ahead of the clock; in mode observed they wait for their time
  std::vector<ros::Subscriber> subscribers_;
  ros::Publisher state_pub_, vessel_force_pub_, vehicle_force_pub_, over_tension_pub_, alarms_pub_, markers_pub_;
  ros::Publisher vehicle_pub_, contacts_pub_, parameters_pub_;
  ros::ServiceServer reset_server_, acknowledge_server_;
  ros::Timer tick_timer_;
  ros::WallTimer diagnostics_timer_;
  ros::WallTime last_vibration_, last_reset_;
  bool had_contact_ = false;
  ForecastPublisher forecast_;
};

}  // namespace tether_monitor
