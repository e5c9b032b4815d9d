#pragma once

#include <array>

namespace tether_monitor::core
{
/// An integration point on [0, 1]: place and weights.
struct QuadraturePoint
{
  double xi;
  double weight;  ///< for loads and whatever is smooth; the three add up to 1.
  double axial;   ///< for the axial energy; with AXIAL_AT_NODES at both ends they add up to 1.
};

/**
 * Three points near those of Gauss, and a little weight of the axial energy at the nodes.
 *
 * Three points see an element stretched rightly that is folded in between: a slope at a node that points backwards
 * shows at none of them, and such a fold carries thousands of newtons as if it were no slack. With 2 per
 * mille of the axial weight at the nodes, and the points moved so that degree 5 is still exact, a fold costs
 * energy and opens. Two points leave a zero-energy motion; five in the middle gain nothing. (M4) of doc/model.md.
 */
inline constexpr std::array<QuadraturePoint, 3> QUADRATURE = {
    {{0.11348172323987354, 0.2789001122334456, 0.27722671156004486},
     {0.5, 0.44219977553310885, 0.4435465768799103},
     {0.8865182767601265, 0.2789001122334456, 0.27722671156004486}}};
inline constexpr double AXIAL_AT_NODES = 0.001;  ///< of the unit interval, each.

}  // namespace tether_monitor::core
