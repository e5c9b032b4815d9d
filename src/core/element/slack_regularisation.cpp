#include "tether_monitor/core/element/slack_regularisation.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/gravity.h"

namespace tether_monitor::core
{
namespace
{
constexpr double BENDING_SHARE = 0.2;           // EI_min over w l^4 / L
constexpr double WEIGHT_SHARE = 1e-3;           // Pc over the dry weight
constexpr double BIGHT_FACTOR = 4.0;            // Pc over the compression in a slack bight
constexpr double LOOP_FACTOR = 60.0;            // Pc over EI / L^2
constexpr double COMPRESSION_STIFFNESS = 1e-5;  // kappa
}  // namespace

SlackRegularisation slackRegularisation(const CableProperties& p, double element_length, double gravity)
{
  const double weight = p.mass_per_length * (gravity > 0.0 ? gravity : STANDARD_GRAVITY);
  const double EI_min = BENDING_SHARE * weight * std::pow(element_length, 4) / p.length;
  const double EI = std::max(p.bending_stiffness, EI_min);
  const double bight = BIGHT_FACTOR * std::cbrt(weight * weight * EI);
  const double loop = LOOP_FACTOR * EI / (p.length * p.length);
  return {std::max({WEIGHT_SHARE * weight * p.length, bight, loop}), COMPRESSION_STIFFNESS, EI};
}

}  // namespace tether_monitor::core
