#pragma once

#include "tether_monitor/monitor/config/config.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// The keys of `solver`, errors collected in `in`.
void loadSolver(ParameterReader in, monitor::Config& config);

/// The groups `tension_sensor` and `direction_sensor`.
void loadSensors(ParameterReader& in, monitor::UncertaintyConfig& uncertainty);

/// The keys of `monitor`, with one group below `alarms` for each of alarmQuantities(); errors collected in `in`.
void loadMonitor(ParameterReader in, monitor::Config& config);

}  // namespace tether_monitor::params
