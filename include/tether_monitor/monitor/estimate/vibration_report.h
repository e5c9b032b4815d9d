#pragma once

#include <optional>
#include <vector>

#include "tether_monitor/core/analysis/natural_modes.h"
#include "tether_monitor/core/analysis/vortex_shedding.h"

namespace tether_monitor::monitor
{
/// Natural frequencies of the tether as it hangs now, beside what excites it.
struct VibrationReport
{
  std::vector<core::Mode> modes;         ///< the lowest, without shapes.
  double encounter_frequency = 0.0;      ///< of the configured waves as the vessel meets them [Hz]; 0: no waves.
  std::optional<core::Mode> resonant;    ///< the mode nearest to it, if it is within 15 %.
  core::VortexShedding vortex_shedding;  ///< against the natural frequencies.
};

/// About a state of a model; `vortex_shedding` is taken over. Takes milliseconds and allocates: at most once a
/// second, outside of the stepping path.
VibrationReport reportVibration(const core::CableModel& model, const core::CableState& state,
                                const core::VortexShedding& vortex_shedding, int modes = 20);

}  // namespace tether_monitor::monitor
