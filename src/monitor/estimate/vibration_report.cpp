#include "tether_monitor/monitor/estimate/vibration_report.h"

#include <cmath>

namespace tether_monitor::monitor
{
namespace
{
constexpr double NEAR = 0.15;  // relative distance of frequencies that resonate
}

VibrationReport reportVibration(const core::CableModel& model, const core::CableState& state,
                                const core::VortexShedding& vortex_shedding, int modes)
{
  VibrationReport report;
  report.vortex_shedding = vortex_shedding;
  report.modes = core::naturalModes(model, state, modes);
  for (core::Mode& mode : report.modes)
    mode.shape.clear();
  const core::AiryWave& wave = model.environment().waves().dominant();
  if (wave.isCalm())
    return report;
  report.encounter_frequency = wave.encounterFrequency(state.v.front().head<3>()) / (2.0 * M_PI);
  double nearest = NEAR;
  for (const core::Mode& mode : report.modes)
  {
    const double distance = std::abs(mode.frequency / report.encounter_frequency - 1.0);
    if (distance < nearest)
    {
      nearest = distance;
      report.resonant = mode;
    }
  }
  return report;
}

}  // namespace tether_monitor::monitor
