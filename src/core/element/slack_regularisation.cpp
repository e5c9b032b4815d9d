#include "tether_monitor/core/element/slack_regularisation.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
SlackRegularisation slackRegularisation(const CableProperties& p, double element_length, double gravity)
{
  const double weight = p.mass_per_length * (gravity > 0.0 ? gravity : 9.81);
  const double EI_min = 0.2 * weight * std::pow(element_length, 4) / p.length;
  const double EI = std::max(p.bending_stiffness, EI_min);
  const double push = std::cbrt(weight * weight * EI);
  const double loop = 60.0 * EI / (p.length * p.length);
  return {std::max({1e-3 * weight * p.length, 4.0 * push, loop}), 1e-5, EI};
}

}  // namespace tether_monitor::core
