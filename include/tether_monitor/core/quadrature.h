#pragma once

#include <array>

namespace tether_monitor::core
{
/// A Gauss-Legendre point on [0, 1]: place and weight; weights add up to 1.
struct GaussPoint
{
  double xi;
  double weight;
};

/// Three points, exact to degree 5: two leave a zero-energy motion of the axial term, five gain nothing.
inline constexpr std::array<GaussPoint, 3> GAUSS_POINTS = {
    {{0.11270166537925831148, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.88729833462074168852, 5.0 / 18.0}}};

}  // namespace tether_monitor::core
