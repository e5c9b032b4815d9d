#pragma once

#include <string>
#include <vector>

#include "verification/estimation_truths.h"

namespace tether_monitor::bench
{
/// How well one parameter is found over many truths.
struct IdentifiedShare
{
  std::string name;
  int truths = 0, within_95 = 0;           ///< truths inside 1.96 standard deviations.
  double rms = 0.0, configured_rms = 0.0;  ///< of identified and of configured from the truth, over the truth [-];
                                           ///< of a current [m/s].
  double stddev = 0.0;                     ///< mean of what is told of it, likewise.
};

/// Drag, weight, length, current and vehicle drag, identified from dives whose truth is drawn from what is told.
std::vector<IdentifiedShare> studyIdentification(const UncertainCase& c, int draws, unsigned first_seed,
                                                 bool has_load_cell);

}  // namespace tether_monitor::bench
