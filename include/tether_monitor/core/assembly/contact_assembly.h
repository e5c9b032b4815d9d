#pragma once

#include <vector>

#include "tether_monitor/core/assembly/contact_detection.h"
#include "tether_monitor/core/linalg/block_tridiagonal.h"
#include "tether_monitor/core/linalg/bordered_block_tridiagonal.h"

namespace tether_monitor::core
{
/// A bordered system for the obstacles that have a mass, of a tether with so many nodes. @param movable  out:
/// which they are.
BorderedSystem borderedSystemFor(const std::vector<Obstacle>& obstacles, int nodes, std::vector<int>& movable);

/**
 * Adds the contact of a tether with the seabed and with obstacles to its residual, (M22) and (M23) of
 * doc/model.md.
 *
 * Normal force: a spring that begins softly and a damper, never in tension. Friction: a spring tied to the surface
 * that slips at mu N, so that a tether at rest stays where it is.
 *
 * @param tangent   out unless null: weighted iteration matrix.
 * @param bordered  out unless null: forces on, and couplings to, the obstacles.
 */
void addContact(const ContactScene& scene, const TangentWeights& weights, NodeField& residual,
                BlockTridiagonal* tangent, BorderedSystem* bordered);

/// Contact force on the nodes of element `i` alone, to be added to its residual.
ElementCoords elementContact(const ContactScene& scene, int i);

/// Gives a state room for the anchor points of friction, tied to where it lies, and its obstacles their places.
/// Once for every state that is to be stepped; allocates.
void initializeContact(const std::vector<ElementParameters>& elements, const EnvironmentModel& environment,
                       CableState& state);

/// Ties the springs of friction anew after an accepted step.
void commitFriction(const std::vector<ElementParameters>& elements, const EnvironmentModel& environment,
                    CableState& state);

}  // namespace tether_monitor::core
