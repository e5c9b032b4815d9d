#pragma once

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <functional>
#include <string>

namespace tether_monitor
{
/// Opens a bag for reading. @throws std::runtime_error naming it and what helps.
void openBag(const std::string& path, rosbag::Bag& bag);

/// The messages of a view of a bag, in order of recording, until it is told to stop.
/// @param visit  returns false: no more of them. @throws std::runtime_error naming the bag: damaged.
void visitMessages(const std::string& path, rosbag::View& view,
                   const std::function<bool(const rosbag::MessageInstance&)>& visit);

}  // namespace tether_monitor
