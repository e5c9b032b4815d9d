#pragma once

#include "tether_monitor/core/cable_model.h"
#include "tether_monitor/monitor/config.h"

namespace tether_monitor::monitor
{
/// The model of a configuration, with its simulated vehicle if it has one. @throws std::invalid_argument listing
/// problems.
core::CableModel modelOf(const Config& config);

/// Whether a configuration can be meshed with another deployed length [m]. What is fixed to the tether keeps its
/// distance from the vehicle end; what has come aboard is left out.
bool isPossibleLength(const Config& config, double length);

/// The model of a configuration at another deployed length [m]; isPossibleLength() must hold.
core::CableModel modelAt(const Config& config, double length);

}  // namespace tether_monitor::monitor
