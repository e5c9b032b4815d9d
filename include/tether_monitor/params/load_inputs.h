#pragma once

#include "tether_monitor/monitor/config/inputs_config.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// `inputs`, `datum` and `payout_joint`; errors collected in `in`.
void loadInputs(ParameterReader& in, monitor::InputsConfig& config);

}  // namespace tether_monitor::params
