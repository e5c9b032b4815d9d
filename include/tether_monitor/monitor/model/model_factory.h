#pragma once

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// The model of a configuration, with its simulated vehicle if it has one. @throws std::invalid_argument listing
/// problems.
core::CableModel makeModel(const Config& config);

/// Whether a configuration can be meshed with another deployed length [m] in so many elements. What is fixed to
/// the tether keeps its distance from the vehicle end; what has come aboard is left out.
bool canMesh(const Config& config, double length, int elements);

/// The model of a configuration at another deployed length [m], canMesh() must hold, in so many elements.
/// @throws std::invalid_argument if it does not.
core::CableModel makeModel(const Config& config, double length, int elements);

/// Whether `model`, or another of its configuration, can have that deployed length [m].
bool canDeploy(const Config& config, const core::CableModel& model, double length);

/// True for a state that the model can be stepped from.
bool isStateOf(const core::CableState& state, const core::CableModel& model);

}  // namespace tether_monitor::monitor
