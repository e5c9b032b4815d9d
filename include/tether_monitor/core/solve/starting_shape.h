#pragma once

#include "tether_monitor/core/solve/steady_ends.h"

#include "tether_monitor/core/assembly/deployed_cable.h"

namespace tether_monitor::core
{
/// The curve from which the search for a steady state starts: a catenary, one that lies on the seabed or floats,
/// or one from which a body hangs, out of all obstacles.
NodeField startingShape(const DeployedCable& cable, const SteadyEnds& ends);

/// Moves nodes out of obstacles by the shortest way, the ends apart.
void projectOutOfObstacles(const DeployedCable& cable, NodeField& shape);

}  // namespace tether_monitor::core
