// Takes the place of ros/bag_replay.cpp and ros/attachment_frames.cpp where there is no ROS.
#include <stdexcept>

#include "tether_monitor/ros/attachment_frames.h"
#include "tether_monitor/ros/bag_replay.h"

namespace tether_monitor
{
std::vector<std::string> replayBag(const std::string& path, const std::string& /*ns*/,
                                   const replay::ReplayOptions& /*options*/,
                                   monitor::TetherEstimator& /*estimator*/, replay::ResultRecorder& /*recorder*/)
{
  throw std::runtime_error("the bag " + path +
                           " cannot be read: this program was built without ROS; use --motion");
}

// The recording is refused afterwards.
params::Value withPlacedAttachments(params::Value tree, const std::string& /*where*/, const std::string& /*bag*/)
{
  return tree;
}

}  // namespace tether_monitor
