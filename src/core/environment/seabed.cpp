#include "tether_monitor/core/environment/seabed.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
// Catmull-Rom weights of the four neighbours of a point at `u` in 0..1, and their derivatives.
struct Weights
{
  std::array<double, 4> value, slope;
};

Weights catmullRom(double u)
{
  return {{0.5 * u * (u * (2.0 - u) - 1.0), 0.5 * (u * u * (3.0 * u - 5.0) + 2.0),
           0.5 * u * (u * (4.0 - 3.0 * u) + 1.0), 0.5 * u * u * (u - 1.0)},
          {0.5 * (u * (4.0 - 3.0 * u) - 1.0), 0.5 * u * (9.0 * u - 10.0), 0.5 * (u * (8.0 - 9.0 * u) + 1.0),
           0.5 * u * (3.0 * u - 2.0)}};
}

// Cell and place in it along one axis; beyond the rim the place stays on it.
struct Cell
{
  Eigen::Index index;
  double u;
  bool inside;
};

Cell locate(double x, double x0, double dx, Eigen::Index nodes)
{
  const double place = (x - x0) / dx;
  const double kept = std::clamp(place, 0.0, static_cast<double>(nodes - 1));
  const Eigen::Index index = std::min(static_cast<Eigen::Index>(kept), nodes - 2);
  return {index, kept - static_cast<double>(index), place == kept};
}

Seabed::Place onGrid(const DepthGrid& grid, double x, double y)
{
  const Cell cx = locate(x, grid.x0, grid.dx, grid.depth.rows());
  const Cell cy = locate(y, grid.y0, grid.dy, grid.depth.cols());
  const Weights wx = catmullRom(cx.u), wy = catmullRom(cy.u);
  double depth = 0.0, along_x = 0.0, along_y = 0.0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
    {
      const double node = grid.depth(std::clamp<Eigen::Index>(cx.index + i - 1, 0, grid.depth.rows() - 1),
                                     std::clamp<Eigen::Index>(cy.index + j - 1, 0, grid.depth.cols() - 1));
      depth += wx.value[i] * wy.value[j] * node;
      along_x += wx.slope[i] * wy.value[j] * node / grid.dx;
      along_y += wx.value[i] * wy.slope[j] * node / grid.dy;
    }
  return {-depth, Vector3(cx.inside ? along_x : 0.0, cy.inside ? along_y : 0.0, 1.0).normalized()};
}
}  // namespace

std::vector<std::string> validate(const DepthGrid& grid)
{
  BoundsCheck check("environment.seabed.grid: ");
  check.positive("spacing in x", grid.dx, "m");
  check.positive("spacing in y", grid.dy, "m");
  check.finite("first x", grid.x0, "m");
  check.finite("first y", grid.y0, "m");
  check.check(grid.depth.rows() >= 2 && grid.depth.cols() >= 2, "number of nodes",
              static_cast<double>(grid.depth.size()), "at least 2 x 2");
  check.check(grid.depth.allFinite(), "depth", grid.depth.sum(), "finite at every node");
  return check.problems();
}

std::vector<std::string> validate(const Seabed& seabed)
{
  BoundsCheck check("environment.seabed.");
  check.positive("depth", seabed.depth, "m");
  check.finite("slope (norm)", seabed.slope.norm(), "[-]");
  check.positive("normal_stiffness", seabed.normal_stiffness, "N/m^3");
  check.notNegative("damping", seabed.damping, "N s/m^3");
  check.notNegative("friction", seabed.friction, "[-]");
  std::vector<std::string> found = check.problems();
  if (seabed.grid)
    for (const std::string& problem : validate(*seabed.grid))
      found.push_back(problem);
  return found;
}

Seabed::Place Seabed::at(double x, double y) const
{
  if (grid)
    return onGrid(*grid, x, y);
  return {-depth - slope.x() * x - slope.y() * y, Vector3(slope.x(), slope.y(), 1.0).normalized()};
}

double Seabed::meanDepth() const
{
  return grid ? grid->depth.mean() : depth;
}

}  // namespace tether_monitor::core
