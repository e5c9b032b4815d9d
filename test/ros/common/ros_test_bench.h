#pragma once

#include <diagnostic_msgs/DiagnosticArray.h>
#include <geometry_msgs/PoseStamped.h>
#include <ros/ros.h>
#include <rosgraph_msgs/Clock.h>
#include <std_msgs/Bool.h>
#include <std_srvs/Trigger.h>
#include <tether_monitor/AlarmArray.h>
#include <tether_monitor/TetherState.h>

#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

namespace tether_monitor
{
/// A vessel, a vehicle and the clock of a test. Time passes only in run(), a tick of the monitor at a time.
class RosTestBench
{
 public:
  RosTestBench()
    : clock_(nh_.advertise<rosgraph_msgs::Clock>("/clock", 10)),
      vessel_(nh_.advertise<geometry_msgs::PoseStamped>("/rov1/vessel/pose", 10)),
      vehicle_(nh_.advertise<geometry_msgs::PoseStamped>("/rov1/vehicle/pose", 10))
  {
    const std::string node = "/rov1/tether_monitor/";
    subscribers_ = {nh_.subscribe(node + "state", 100, &RosTestBench::onState, this),
                    nh_.subscribe(node + "over_tension", 100, &RosTestBench::onOverTension, this),
                    nh_.subscribe(node + "alarms", 100, &RosTestBench::onAlarms, this),
                    nh_.subscribe("/diagnostics", 100, &RosTestBench::onDiagnostics, this)};
    waitFor(
        [this]
        {
          return vessel_.getNumSubscribers() > 0 && vehicle_.getNumSubscribers() > 0 &&
                 subscribers_[0].getNumPublishers() > 0 && clock_.getNumSubscribers() > 1;
        },
        20.0);
    setClock();
    ros::WallDuration(0.1).sleep();
  }

  /// Lets `duration` seconds pass, 50 ms at a time; the poses are published before the clock moves to their stamp.
  void run(double duration)
  {
    for (const double end = time + duration; time < end - 1e-9;)
    {
      time += 0.05;
      vehicle_position[0] += 0.05 * vehicle_velocity[0];
      vehicle_position[2] += 0.05 * vehicle_velocity[2];
      if (vessel_alive)
        vessel_.publish(pose(vessel_position, frame));
      if (vehicle_alive)
        vehicle_.publish(pose(vehicle_position, frame));
      ros::WallDuration(0.004).sleep();  // poses travel on other sockets than the clock
      // The state and the word travel on two sockets: wait for both of this tick.
      const int words = over_tension_count;
      setClock();
      waitFor([&] { return std::abs(state.header.stamp.toSec() - time) < 1e-3 && over_tension_count > words; },
              2.0);
    }
  }

  template <typename Condition>
  bool waitFor(const Condition& condition, double wall_seconds)
  {
    const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(wall_seconds);
    while (ros::ok() && ros::WallTime::now() < end)
    {
      ros::spinOnce();
      if (condition())
        return true;
      ros::WallDuration(0.0005).sleep();
    }
    return false;
  }

  geometry_msgs::PoseStamped pose(const std::array<double, 3>& at, const std::string& frame_id) const
  {
    geometry_msgs::PoseStamped message;
    message.header.stamp = ros::Time(time);
    message.header.frame_id = frame_id;
    message.pose.position.x = at[0];
    message.pose.position.y = at[1];
    message.pose.position.z = at[2];
    message.pose.orientation.w = 1.0;
    return message;
  }

  void publishVehicle(const geometry_msgs::PoseStamped& message) { vehicle_.publish(message); }

  /// Calls a std_srvs/Trigger service of the node; the answer's text, or "failed".
  std::string call(const std::string& service)
  {
    std_srvs::Trigger trigger;
    return ros::service::call("/rov1/tether_monitor/" + service, trigger) && trigger.response.success
               ? trigger.response.message
               : "failed";
  }

  const Alarm* alarm(const std::string& name) const
  {
    for (const Alarm& a : alarms.alarms)
      if (a.name == name)
        return &a;
    return nullptr;
  }

  /// Waits for a diagnostic whose values or message contain `text`.
  bool diagnosticsSay(const std::string& text)
  {
    const bool said = waitFor([&] { return diagnostics_text_.find(text) != std::string::npos; }, 5.0);
    if (!said)
      ROS_ERROR_STREAM("the diagnostics say:\n" << diagnostics_text_);
    return said;
  }

  double time = 1000.0;
  std::array<double, 3> vessel_position{0.0, 0.0, 1.0};
  std::array<double, 3> vehicle_position{60.0, 0.0, -70.0};
  std::array<double, 3> vehicle_velocity{0.0, 0.0, 0.0};
  bool vessel_alive = true;
  bool vehicle_alive = true;
  std::string frame = "map";

  TetherState state;
  bool over_tension = true;
  int over_tension_count = 0;
  AlarmArray alarms;

 private:
  void setClock()
  {
    rosgraph_msgs::Clock now;
    now.clock = ros::Time(time);
    clock_.publish(now);
  }
  void onState(const TetherState& message) { state = message; }
  void onOverTension(const std_msgs::Bool& message)
  {
    over_tension = message.data;
    ++over_tension_count;
  }
  void onAlarms(const AlarmArray& message) { alarms = message; }
  void onDiagnostics(const diagnostic_msgs::DiagnosticArray& message)
  {
    diagnostics_text_.clear();
    for (const auto& status : message.status)
    {
      diagnostics_text_ += status.message + "\n";
      for (const auto& value : status.values)
        diagnostics_text_ += value.key + ": " + value.value + "\n";
    }
  }

  ros::NodeHandle nh_;
  ros::Publisher clock_, vessel_, vehicle_;
  std::vector<ros::Subscriber> subscribers_;
  std::string diagnostics_text_;
};

}  // namespace tether_monitor
