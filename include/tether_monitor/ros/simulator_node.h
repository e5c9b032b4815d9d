#pragma once

#include <nav_msgs/Odometry.h>
#include <ros/ros.h>
#include <tf2_ros/transform_broadcaster.h>

#include <functional>
#include <string>

#include "tether_monitor/simulation/heave_sensor.h"
#include "tether_monitor/simulation/position_sensor.h"
#include "tether_monitor/simulation/simulator.h"

namespace tether_monitor
{
/**
 * A simulated vessel, tether and vehicle on ROS: what the monitor subscribes to, and the truth beside it.
 *
 * **Publishes** (relative): vessel/pose, vessel/velocity, vehicle/pose, vehicle/velocity, payout, obstacles,
 * vehicle/thrust (if the monitor's vehicle is free); (private) vessel_end/force, vehicle_end/force: the true
 * forces of the tether on its ends, and markers: hull and vehicle. Frames NS/vessel and NS/vehicle on /tf. With
 * `simulation.clock` also /clock. **Subscribes** (relative): winch/command (std_msgs/Float64, pay-out rate in m/s;
 * a command is good for a second) with `simulation.winch_command`, vehicle/command (geometry_msgs/Wrench, own
 * axes) with the control `external`, tether_monitor/state with `simulation.lockstep`.
 */
class SimulatorNode
{
 public:
  /**
   * @param nh          for outputs.
   * @param private_nh  for parameters: the tree of the monitor with the key `simulation`.
   * @throws params::ParameterError listing every fault of the parameters; std::runtime_error if there is no steady
   * state to start from.
   */
  SimulatorNode(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh);

  /// Whether the simulation still runs: its solver has not failed.
  bool isRunning() const { return running_; }

 private:
  void begin(const ros::Time& now);
  void tick();
  void publishMeasurements(double t);
  void publishBody(const simulation::Measurement& measurement, const ros::Publisher& pose,
                   const ros::Publisher& velocity);
  void publishOdometry(const simulation::Measurement& measurement);
  void publishHeave(double t);
  void publishWinch(double t);
  void publishObstacles(double t);
  void publishClock();
  void publishTruth();
  void subscribeToCommands();
  void dropOldCommands();
  bool mustWait();
  ros::Time stamp(double t) const { return start_ + ros::Duration(t); }

  ros::NodeHandle nh_, private_nh_;
  simulation::SimulationConfig plan_;
  monitor::Config config_;
  simulation::Simulator simulator_;
  simulation::Sensor vessel_sensor_, vehicle_sensor_;
  simulation::HeaveSensor heave_sensor_;
  std::mt19937 generator_;
  tf2_ros::TransformBroadcaster broadcaster_;
  std::string frame_prefix_;
  ros::Publisher vessel_pose_, vessel_velocity_, vehicle_pose_, vehicle_velocity_, payout_, obstacles_, thrust_;
  ros::Publisher vessel_odometry_;
  ros::Publisher vessel_force_, vehicle_force_, markers_, clock_;
  ros::Subscriber winch_command_, thrust_command_, monitor_state_;
  double winch_commanded_at_ = -1e300;   // [s]
  double thrust_commanded_at_ = -1e300;  // [s]
  double monitored_ = 0.0;               // [s], of the monitor's last state
  ros::WallTime waits_since_;            // zero: it does not
  ros::Timer timer_;
  ros::WallTimer wall_timer_;
  ros::Time start_;
  double period_ = 0.05;  // [s] of simulated time between ticks
  long steps_ = 0;
  double time_ = 0.0;  // [s], steps times period: a sum of a million steps would leave the beat of the monitor
  double next_payout_ = 0.0, next_obstacles_ = 0.0;
  bool started_ = false;
  bool running_ = true;
  ros::WallTime made_at_ = ros::WallTime::now();
};

}  // namespace tether_monitor
