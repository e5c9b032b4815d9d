#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tether_monitor/core/assembly/station_profile.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::bench
{
/// A motion with a known answer: a tether, what drives it, how long.
struct Case
{
  std::string name, what;
  core::CableProperties tether;
  core::Environment sea;
  core::EndBodies bodies;
  double duration = 0.0;    ///< [s]
  double count_from = 0.0;  ///< errors count from here [s].
  double output = 0.05;     ///< interval of the record [s].
  core::SteadyEnds start;   ///< steady state from which it begins.
  std::function<core::EndMotion(double)> vessel, vehicle;
  int reference_elements = 400;
  double reference_step = 0.005;
};

/// The cases A to F of bench/README.md.
std::vector<Case> cases();

/// End tensions over time, and what they cost.
struct Record
{
  std::vector<double> vessel, vehicle;  ///< [N] at every multiple of the output interval after the start.
  double cpu = 0.0;                     ///< [s] of the stepping alone.
  core::SolveReport total;
  int worst_iterations = 0, worst_pieces = 0;  ///< of one advance() over a largest step: iterations, substeps.
  std::vector<int> iterations;                 ///< of every advance().
  std::vector<double> times;                   ///< CPU time of every advance() [s].
  bool complete = false;
};

/// Runs a case from its steady state. @param kernel  nullptr: the best.
Record run(const Case& c, int elements, const core::StepperOptions& options,
           const core::kernel::Kernel* kernel = nullptr);

/// RMS of the difference over the mean of the reference, and relative difference of the peaks, from count_from on.
struct Deviation
{
  double rms = 0.0, peak = 0.0;
};
Deviation deviation(const Case& c, const std::vector<double>& record, const std::vector<double>& reference,
                    double output);

/// CPU time of this thread [s].
double cpuTime();
}  // namespace tether_monitor::bench
