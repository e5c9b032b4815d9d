#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tether_monitor/core/environment/wave_spectrum.h"

namespace tether_monitor::core
{
/// What linear waves do above still water, where their own profile does not end.
enum class WaveStretching
{
  WHEELER,  ///< the profile from still water to the floor is stretched to the instantaneous surface.
  NONE,     ///< as linear theory has it below still water, above it as at it.
};

/// The waves, as a user describes them: regular ones, or a spectrum, or none.
struct SeaState
{
  std::vector<WaveProperties> components;
  std::optional<WaveSpectrum> spectrum;  ///< instead of components.
  WaveStretching stretching = WaveStretching::WHEELER;

  bool isCalm() const;
  /// Largest height of the surface over still water that all components make together [m]; a spectrum's is Hs.
  double largestElevation() const;
};

/// Every bound of SeaState that `waves` violates, one sentence each.
/// @param gravity  [m/s^2]
std::vector<std::string> validate(const SeaState& waves, double gravity);

}  // namespace tether_monitor::core
