#pragma once

#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/monitor/estimate/tether_estimate.h"

namespace tether_monitor::monitor
{
/// Fills the numbers of `estimate` that follow from its stations: extremes, utilisations (each station against the
/// loads of its own section, the weaker one at a boundary), angles. Allocates nothing.
void summarize(const core::DeployedCable& cable, TetherEstimate& estimate);

/// Fills what the tether touches, in the world.
void describeContact(const core::DeployedCable& cable, const core::CableState& state, TetherEstimate& estimate);

/// Fills the pose and the rates of the body at the vehicle end of a model that has one.
void describeVehicle(const core::DeployedCable& cable, const core::CableState& state, TetherEstimate& estimate);

/// Whether the model is near its range: REASON_OUT_OF_RANGE above the breaking load, 10 % strain or where pressure
/// takes more than half of the diameter, MESH_COARSE where the tether turns by more than 1.2 rad within one
/// element (in mode observed: the median of the members) or is crumpled by 10 %, else NONE.
Reason modelRange(const core::DeployedCable& cable, const TetherEstimate& estimate);

/// Sets INVALID with a reason and takes every number of the model out; ages and time stay.
void invalidate(Reason reason, TetherEstimate& estimate);

}  // namespace tether_monitor::monitor
