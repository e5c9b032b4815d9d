#include <ros/ros.h>

#include <exception>
#include <memory>

#include "tether_monitor/ros/simulator_node.h"

int main(int argc, char** argv)
{
  ros::init(argc, argv, "tether_sim");
  const ros::NodeHandle nh, private_nh("~");
  std::unique_ptr<tether_monitor::SimulatorNode> sim;
  try
  {
    sim = std::make_unique<tether_monitor::SimulatorNode>(nh, private_nh);
  }
  catch (const std::exception& error)
  {
    ROS_FATAL("%s", error.what());
    return 1;
  }
  ros::spin();
  return sim->isRunning() ? 0 : 1;
}
