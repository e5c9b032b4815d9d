#pragma once

#include <functional>

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/solve/adaptive_stepper.h"
#include "tether_monitor/core/solve/steady_state_solver.h"

namespace tether_monitor::core
{
/// How finely a tether is to be cut in space and time.
struct MeshSelection
{
  int elements = 0;
  double step = 0.0;   ///< [s], at most that of the options.
  double error = 0.0;  ///< expected RMS error of the end tensions over their mean in the trial motion [-].
  bool converged =
      false;  ///< false: MOST_ELEMENTS are not enough, or the trials were inconclusive (error infinite).

  template <class Archive>
  void serialize(Archive& a)
  {
    a(elements, step, error, converged);
  }
};

constexpr int FEWEST_ELEMENTS = 8, MOST_ELEMENTS = 200;  ///< that selectMesh() considers.

/**
 * Number of elements and time step for a requested accuracy, from the tether, its ends and what surrounds it.
 *
 * From the steady state the ends are moved as ends at sea are: the vessel heaves (up to 1 m, 8 s), a held vehicle
 * circles (up to 5 m, 60 s), and both gather way ahead and astern (1.5 m/s): less where the tether has no slack
 * for it. The same motion with twice the elements, and with half the step, give the error; (M29) of doc/model.md.
 *
 * For set-up: takes memory, and up to a second or two of computing, which a budget of iterations bounds.
 *
 * @param make      the model with a given number of elements; throws std::invalid_argument for too few.
 * @param ends      where the tether is now.
 * @param accuracy  [-], > 0.
 * @param options   its step is the longest that is chosen.
 * @param fallback  number of elements, possible, that is returned with the given step if the trials tell nothing.
 * @return          never a number that `make` refuses.
 */
MeshSelection selectMesh(const std::function<CableModel(int)>& make, const SteadyEnds& ends, double accuracy,
                         const StepperOptions& options, int fallback = 50);

}  // namespace tether_monitor::core
