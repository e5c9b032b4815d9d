#pragma once

#include <cstdint>
#include <random>

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::fuzz
{
/// A tether with its ends, drawn by chance: the same for the same seed, everywhere.
struct RandomTether
{
  core::CableProperties tether;
  core::Environment sea;
  core::EndBodies bodies;
  core::SteadyEnds ends;
};

/// Numbers drawn from a seed, or from given bytes as long as they last. Own arithmetic on the bits: the library's
/// distributions differ between libraries.
class RandomSource
{
 public:
  explicit RandomSource(unsigned seed) : bits_(seed) {}
  RandomSource(const std::uint8_t* bytes, std::size_t count) : bits_(1), bytes_(bytes), left_(count) {}
  double uniform(double from, double to)
  {
    return from + (to - from) * (static_cast<double>(draw()) / 4294967296.0);
  }
  /// Evenly spread in its logarithm.
  double scale(double from, double to);
  bool chance(double probability) { return uniform(0.0, 1.0) < probability; }
  /// A direction, evenly spread over the sphere.
  core::Vector3 direction();

 private:
  std::uint32_t draw();

  std::mt19937 bits_;
  const std::uint8_t* bytes_ = nullptr;
  std::size_t left_ = 0;
};

/// A tether that could be built and used: 1 m to 10 km, 2 mm to 0.3 m, buoyant to chain, EA 1e3 to 1e9 N; own
/// weight and drag stretch it by 5 % at most. Ends from together to 1 % too far apart, a quarter of them with a
/// body, half of them in motion or in a current.
RandomTether plausibleTether(RandomSource& dice);

/// Any tether within the bounds of the parameters: lengths, stiffness and diameter by themselves, ends up to 20 %
/// too far apart.
RandomTether arbitraryTether(RandomSource& dice);

/// A tether that sinks, at rest between a vessel above the floor and an end on it or near it; friction 0 to 1,
/// slopes up to 0.2, a third of them in a current.
RandomTether tetherOnSeabed(RandomSource& dice);
}  // namespace tether_monitor::fuzz
