#pragma once

#include <string>
#include <vector>

#include "tether_monitor/core/bodies/rigid_body.h"

namespace tether_monitor::simulation
{
/// Main dimensions of a ship.
struct ShipProperties
{
  double length = 30.0;  ///< [m], > 0.
  double beam = 8.0;     ///< [m], > 0.
  double draft = 2.5;    ///< [m], > 0.
  double height = 6.0;   ///< of the hull, keel to deck [m], > draft.
};

/// Every bound of ShipProperties that `ship` violates, one sentence each.
std::vector<std::string> validate(const ShipProperties& ship);

/**
 * A box-shaped ship that floats at its draft: mass by its displacement, centre of mass at nine tenths of the draft
 * above the keel, radii of gyration, added mass, drag and wind areas as is usual for its size. Its reference point
 * is its centre of mass.
 */
core::RigidBody makeBoxShip(const ShipProperties& ship, double water_density);

/// Height of the centre of mass over still water when the ship floats at its draft [m].
double equilibriumHeight(const ShipProperties& ship);

}  // namespace tether_monitor::simulation
