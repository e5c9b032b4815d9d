#include "tether_monitor/core/element/axial_law.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
namespace
{
constexpr int ITERATIONS = 60;
constexpr double ROUNDING = 1e-15;

double tensionOf(const AxialParameters& p, double x)
{
  return x * axialResponse(p, strainOfStretch(x)).force;
}
}  // namespace

// Newton's method on the piece of the curve that holds the answer, from above: each piece is a convex cubic.
double stretchAtTension(const AxialParameters& p, double tension)
{
  double least = 1.0, stiffness = p.stiffness;
  for (int k = 0; k < p.stiffening.count; ++k)
  {
    const double next = std::sqrt(1.0 + 2.0 * p.stiffening.strain[k]);
    if (!(tensionOf(p, next) < tension))
      break;
    least = next;
    stiffness += p.stiffening.change[k];
  }
  const double offset = tensionOf(p, least) / least - stiffness * strainOfStretch(least);  // N = offset + EA eps
  double x = least;
  for (int i = 0; i < ITERATIONS && tension > 0.0; ++i)
  {
    const double force = offset + stiffness * strainOfStretch(x);
    const double step = (x * force - tension) / (force + x * x * stiffness);
    x -= step;
    if (std::abs(step) <= ROUNDING * x)
      break;
  }
  return std::max(x, 1.0);
}

}  // namespace tether_monitor::core
