#include <nodelet/nodelet.h>
#include <pluginlib/class_list_macros.hpp>

#include <memory>

#include "tether_monitor/ros/monitor_node.h"

namespace tether_monitor
{
/// The node, in the process of a nodelet manager.
class MonitorNodelet : public nodelet::Nodelet
{
 private:
  void onInit() override
  {
    try
    {
      node_ = std::make_unique<MonitorNode>(getNodeHandle(), getPrivateNodeHandle());
    }
    catch (const std::exception& error)
    {
      NODELET_FATAL("%s", error.what());
      throw;  // the manager then does not load it
    }
  }

  std::unique_ptr<MonitorNode> node_;
};

}  // namespace tether_monitor

PLUGINLIB_EXPORT_CLASS(tether_monitor::MonitorNodelet, nodelet::Nodelet)
