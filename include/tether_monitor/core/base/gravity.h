#pragma once

namespace tether_monitor::core
{
/// Standard gravity [m/s^2]: the unit of scales where an environment has no gravity, or another.
constexpr double STANDARD_GRAVITY = 9.81;

}  // namespace tether_monitor::core
