#pragma once

#include "tether_monitor/core/element/element_parameters.h"

namespace tether_monitor::core
{
// The coordinates of an element as it has them: those of its nodes, but for a slope that follows from the
// neighbour's (see SlopeTransition).

/// Coordinates of element `i` with constants `p`.
ElementCoords elementCoords(const ElementParameters& p, const NodeField& q, int i);
/// Their rates.
ElementCoords elementRates(const ElementParameters& p, const NodeField& q, const NodeField& v, int i);
/// The rates of these.
ElementCoords elementAccelerations(const ElementParameters& p, const NodeField& q, const NodeField& v,
                                   const NodeField& a, int i);

/// Forces on an element's own coordinates, in and out: on those of its nodes.
void pullBack(const ElementParameters& p, const NodeField& q, int i, ElementCoords& force);
/// The same with its iteration matrix, which gets the part that turns and grows with the map.
/// @param stiffness  weight of the derivative with the coordinates, see TangentWeights.
void pullBack(const ElementParameters& p, const NodeField& q, int i, double stiffness, ElementCoords& force,
              ElementMatrix& matrix);

}  // namespace tether_monitor::core
