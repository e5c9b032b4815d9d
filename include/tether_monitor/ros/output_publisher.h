#pragma once

#include <ros/ros.h>
#include <tether_monitor/TetherState.h>
#include <visualization_msgs/MarkerArray.h>

#include <functional>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/ros/alarm_publisher.h"
#include "tether_monitor/ros/cycle_output.h"
#include "tether_monitor/ros/simulator_bridge.h"
#include "tether_monitor/ros/standard_outputs.h"

namespace tether_monitor
{
/**
 * **Publishes** (private): over_tension, state, vessel_end/force, vehicle_end/force, vehicle_end/wrench_body,
 * vehicle/estimate, contacts, parameters, alarms, events, markers; the simulators' topics, see SimulatorBridge;
 * and StandardOutputs.
 */
class OutputPublisher
{
 public:
  using MakeMarkers = std::function<visualization_msgs::MarkerArray(const std_msgs::Header&)>;

  /// @param has_ensemble,has_vehicle  what the estimator has. @param make_markers  called when somebody wants
  /// them.
  OutputPublisher(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, const monitor::Config& config,
                  bool has_ensemble, bool has_vehicle, MakeMarkers make_markers);

  /// What a control loop waits for: first, and never shed.
  void publishFlag(const CycleOutput& output);
  /// Alarms and their events: never shed.
  void publishAlarms(const CycleOutput& output);
  /// All other numbers.
  void publishNumbers(const CycleOutput& output);
  /// For rviz, if somebody looks: the first to go.
  void publishMarkers(const CycleOutput& output);
  /// What is in the log was published by the node that wrote it.
  void skipEvents(const monitor::AlarmSet& alarms) { alarms_.skip(alarms); }

 private:
  std_msgs::Header headerOf(const CycleOutput& output) const;

  const monitor::Config config_;
  const MakeMarkers make_markers_;
  ros::NodeHandle nh_;
  ros::Publisher over_tension_, state_, vessel_force_, vehicle_force_, wrench_body_, vehicle_, contacts_,
      parameters_, markers_;
  AlarmPublisher alarms_;
  SimulatorBridge bridge_;
  StandardOutputs standard_;
  TetherState state_message_;
};

}  // namespace tether_monitor
