#pragma once

#include <string>

#include "tether_monitor/params/parameter_value.h"

namespace ros
{
class NodeHandle;
}

namespace tether_monitor
{
/**
 * A parameter tree in which attachments that name a frame are numbers, by the transforms on /tf_static and /tf,
 * which are waited for ten seconds of the wall clock. Where there is none, nothing is waited for.
 *
 * @param nh  its namespace is named in errors.
 * @throws params::ParameterError naming those whose transforms have not come.
 */
params::Value withPlacedAttachments(params::Value tree, const ros::NodeHandle& nh);

/**
 * The same by the transforms of a bag.
 *
 * @param where  named in errors.
 * @throws params::ParameterError; std::runtime_error if the bag cannot be read.
 */
params::Value withPlacedAttachments(params::Value tree, const std::string& where, const std::string& bag);

}  // namespace tether_monitor
