#pragma once

#include "tether_monitor/core/environment/sea_state.h"
#include "tether_monitor/params/parameter_reader.h"

namespace tether_monitor::params
{
/// `environment.waves`: one regular wave, a list of them, or a spectrum; errors collected in `environment`.
core::SeaState loadWaves(ParameterReader& environment);

}  // namespace tether_monitor::params
