#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"
#include "tether_monitor/params/parameter_value.h"

namespace tether_monitor::params
{
/// Where the origin of a frame of tf is on a body, in the axes of the body's frame [m]; none: it is not known.
using FrameOrigin =
    std::function<std::optional<core::Vector3>(const std::string& frame, const std::string& body_frame)>;

/**
 * Puts numbers in the place of a `vessel.attachment` and `vehicle.attachment` that name a frame.
 *
 * @return a text for each whose place is not known; it stays a name.
 */
std::vector<std::string> placeAttachments(Value& tree, const FrameOrigin& origin);

}  // namespace tether_monitor::params
