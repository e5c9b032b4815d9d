#pragma once

#include "tether_monitor/core/assembly/deployed_cable.h"

namespace tether_monitor::core
{
/// Weight and drag per metre [N/m] on a straight tether along the chord, averaged over its depth.
Vector3 netLoad(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle,
                const Vector3& velocity);

/**
 * A starting curve for the steady state: a catenary bowed along the net load (weight and drag), never through
 * compression.
 *
 * @param vessel, vehicle  positions of the two ends [m].
 * @param velocity         common velocity of both ends [m/s].
 * @return                 coordinates of every node.
 */
NodeField catenaryGuess(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle,
                        const Vector3& velocity);

/**
 * A starting curve for a body that hangs from the tether: the tension vector is integrated from the body to the
 * vessel, dn/ds = -load, and the curve follows it. Loads that change with depth are taken at the depths of the
 * pass before.
 *
 * @param vessel    position of the vessel end [m].
 * @param velocity  common velocity of both ends [m/s].
 */
NodeField hangingBodyGuess(const DeployedCable& cable, const Vector3& vessel, const Vector3& velocity,
                           const RigidBody& body);

}  // namespace tether_monitor::core
