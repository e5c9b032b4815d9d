#pragma once

#include <functional>

#include "verification/estimation_truths.h"

namespace tether_monitor::bench
{
/// A case with the truth that was drawn from what is told of it.
struct DrawnTruth
{
  UncertainCase of;
  unsigned seed = 0;
  TruthDraw draw;
  Truth truth;
};

/// Bias that was drawn for the load cell of an estimator of this configuration [N].
double tensionBias(const DrawnTruth& drawn, const monitor::Config& config);

/**
 * Draws truths and hands each to `use`, in any order and from several threads at once. Truths without a steady
 * state, and those that get too taut to go on, are left out.
 *
 * @param of          the case of a seed.
 * @param is_as_told  nothing is drawn: every truth is what is told of it.
 */
void forEachTruth(const std::function<UncertainCase(unsigned seed)>& of, int draws, unsigned first_seed,
                  int threads, bool is_as_told, const std::function<void(const DrawnTruth&)>& use);

}  // namespace tether_monitor::bench
