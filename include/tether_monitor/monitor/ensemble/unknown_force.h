#pragma once

#include "tether_monitor/monitor/config/config.h"

namespace tether_monitor::monitor
{
/// What pushes the vehicle and is not in the model: a slow and a fast force, each a first-order Gauss-Markov
/// process, alike along every axis.
struct UnknownForce
{
  double slow_stddev = 1.0;     ///< [N], > 0.
  double slow_memory = 3600.0;  ///< [s]
  double fast_stddev = 1.0;     ///< [N], > 0.
  double fast_memory = 15.0;    ///< [s]
};

/// What is told of it: (E3) of doc/theory/estimation.md.
UnknownForce unknownForceOf(const Config& config);

}  // namespace tether_monitor::monitor
