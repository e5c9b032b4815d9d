#pragma once

#include <string>

#include "verification/random_tether.h"

namespace tether_monitor::fuzz
{
/// A random element in a random state, through every kernel: what is wrong with its residual or tangent, or
/// nothing. Finite coordinates must give finite forces, and all kernels the same.
std::string checkElement(RandomSource& dice);

/// A random tether in random motion, with teleports, reversals and garbage, through the estimator. Every estimate
/// must be finite, or INVALID with a reason; the iterations must stay within the budget.
std::string checkTether(RandomSource& dice);

/// What became of a steady state in the minute that followed.
struct RestOutcome
{
  bool found = false;  ///< else the estimator said that there is none, or none at rest.
  double drift = 0.0;  ///< change of an end force over the larger [-].
};

/// Finds the steady state of tetherOnSeabed() and steps it for a minute with its ends held.
RestOutcome restOnSeabed(RandomSource& dice);
}  // namespace tether_monitor::fuzz
