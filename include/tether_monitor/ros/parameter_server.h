#pragma once

#include <ros/node_handle.h>

#include "tether_monitor/params/parameter_value.h"

namespace tether_monitor
{
/// The whole parameter tree below the namespace of `nh`, read in one round trip; an empty map if there is nothing.
params::Value readParameterServer(const ros::NodeHandle& nh);

}  // namespace tether_monitor
