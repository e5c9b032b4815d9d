#include <ros/ros.h>

#include "tether_monitor/ros/tether_monitor_ros.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "tether_monitor");
  try
  {
    tether_monitor::TetherMonitorRos monitor(ros::NodeHandle(), ros::NodeHandle("~"));
    ros::spin();
  }
  catch (const std::exception& error)
  {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
