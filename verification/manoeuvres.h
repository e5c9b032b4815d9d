#pragma once

#include <functional>
#include <random>
#include <string>
#include <vector>

#include "verification/estimation_truths.h"

namespace tether_monitor::bench
{
/// When a manoeuvre begins, and how long a dive with one is [s].
constexpr double MANOEUVRE_BEGINS = 75.0, MANOEUVRE_DURATION = 170.0;

/// What a vessel, a winch or a pilot does after a while of steady motion. How much of it, and how quickly, is
/// drawn.
struct Manoeuvre
{
  std::string what;
  double most_margin = 2.0;  ///< largest working load, over the largest tension before it begins.
  std::function<UncertainCase(std::mt19937&)> draw;
};

/// A tow that speeds up, begins to heave, comes out of a turn, or whose winch stops; a vehicle that pulls away,
/// and a vessel that leaves one behind.
std::vector<Manoeuvre> manoeuvres();

}  // namespace tether_monitor::bench
