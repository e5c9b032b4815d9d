#include "tether_monitor/core/axial_law.h"

#include <algorithm>

namespace tether_monitor::core
{
double strainOfTension(const AxialParameters& p, double tension)
{
  double eps = tension / p.stiffness;
  if (tension < 0.0)
    eps = std::max(eps, -0.45);
  for (int i = 0; i < 40; ++i)
  {
    const AxialLaw law = axialLaw(p, eps);
    const double stretch = std::sqrt(std::max(1.0 + 2.0 * eps, 1e-6));
    const double error = law.force * stretch - tension;
    const double slope = law.modulus * stretch + law.force / stretch;
    if (!(slope > 0.0))
      break;
    const double next = std::max(eps - error / slope, 0.5 * (eps - 0.499));
    if (std::abs(next - eps) <= 1e-15 * (1.0 + std::abs(eps)))
      break;
    eps = next;
  }
  return eps;
}

}  // namespace tether_monitor::core
