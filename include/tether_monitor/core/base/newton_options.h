#pragma once

namespace tether_monitor::core
{
/// When Newton's iteration ends.
struct NewtonOptions
{
  double relative_tolerance = 1e-6;  ///< largest residual over the force scale plus the end reactions [-], > 0.
  int max_iterations = 10;           ///< >= 1.
};

}  // namespace tether_monitor::core
