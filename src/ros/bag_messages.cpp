#include "tether_monitor/ros/bag_messages.h"

#include <stdexcept>

namespace tether_monitor
{
void openBag(const std::string& path, rosbag::Bag& bag)
{
  try
  {
    bag.open(path, rosbag::bagmode::Read);
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("cannot read the bag " + path + ": " + error.what() +
                             " (a truncated bag may be mended with rosbag reindex)");
  }
}

void visitMessages(const std::string& path, rosbag::View& view,
                   const std::function<bool(const rosbag::MessageInstance&)>& visit)
{
  try
  {
    for (const rosbag::MessageInstance& message : view)
      if (!visit(message))
        return;
  }
  catch (const std::exception& error)
  {
    throw std::runtime_error("the bag " + path + " is damaged: " + error.what());
  }
}

}  // namespace tether_monitor
