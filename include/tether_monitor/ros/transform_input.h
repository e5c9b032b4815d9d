#pragma once

#include <ros/time.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <optional>
#include <string>

#include "tether_monitor/ros/message_bounds.h"

namespace tether_monitor
{
/**
 * Accepts transforms into a buffer, and refuses those on which tf2 throws or that would drive out all others:
 * numbers that are not finite, stamps far ahead of the clock.
 *
 * @param now  of the clock; zero: stamps are not looked at (a recording).
 * @return     what was wrong with the first that was refused.
 */
std::optional<InputError> addTransforms(const tf2_msgs::TFMessage& message, bool is_static, const ros::Time& now,
                                        tf2::BufferCore& buffer);

}  // namespace tether_monitor
