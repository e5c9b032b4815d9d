#include <ros/ros.h>

#include "tether_monitor/ros/monitor_node.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "tether_monitor");
  // Declared outside the try block: with the last handle gone, ROS would shut down before it could log the error.
  const ros::NodeHandle nh;
  const ros::NodeHandle private_nh("~");
  try
  {
    tether_monitor::MonitorNode monitor(nh, private_nh);
    ros::spin();
  }
  catch (const std::exception& error)
  {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  return 0;
}
