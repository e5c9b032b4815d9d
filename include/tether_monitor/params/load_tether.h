#pragma once

#include <optional>

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// The keys of `tether`, errors collected in `in`.
void loadTether(ParameterReader in, monitor::Config& config);

/// The keys of `winch`, errors collected in `in`.
std::optional<core::WinchProperties> loadWinch(ParameterReader in);

}  // namespace tether_monitor::params
