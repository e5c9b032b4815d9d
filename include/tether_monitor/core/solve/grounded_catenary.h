#pragma once

#include <optional>

#include "tether_monitor/core/assembly/deployed_cable.h"

namespace tether_monitor::core
{
/**
 * A starting curve for a tether that reaches the seabed: a catenary leg from each end down to the floor, and what
 * is left lies between the feet, straight if that is its length, else in an arc.
 *
 * @param cable            has a seabed.
 * @param vessel, vehicle  positions of the two ends [m]; one below the floor counts as on it.
 * @return                 coordinates of every node; empty if a tether of this length does not reach the floor.
 */
NodeField groundedCatenary(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle);

/// The same upside down for a tether lighter than water that reaches the surface: what is left floats there, and
/// trails where `drift`, the horizontal load per metre [N/m], carries it.
NodeField floatingCatenary(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle,
                           const Vector3& drift);

/// Height at which a piece of the tether floats by itself [m]; nothing if it sinks.
std::optional<double> floatingHeight(const DeployedCable& cable);

}  // namespace tether_monitor::core
