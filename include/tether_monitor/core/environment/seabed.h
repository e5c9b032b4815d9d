#pragma once

#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// Depth of the sea on a regular grid over the area, smooth in between (Catmull-Rom), constant beyond the rim.
struct DepthGrid
{
  double x0 = 0.0, y0 = 0.0;  ///< first node [m].
  double dx = 1.0, dy = 1.0;  ///< spacing [m], > 0.
  Eigen::MatrixXd depth;      ///< [m] below still water; depth(i, j) at (x0 + i dx, y0 + j dy); 2 x 2 or more.
};

/// Every bound of DepthGrid that `grid` violates, one sentence each.
std::vector<std::string> validate(const DepthGrid& grid);

/// The sea floor: where it is and what it does to a tether that touches it.
struct Seabed
{
  double depth = 1000.0;                            ///< [m] below still water at the origin of the world, > 0.
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();  ///< rise of depth per metre east and north [-].
  double normal_stiffness = 3.0e5;                  ///< k [N/m^3], > 0: force per metre k d * penetration.
  double damping = 3.0e4;                 ///< c [N s/m^3], >= 0: force per metre c d * speed of penetration.
  double friction = 0.3;                  ///< Coulomb's mu [-], >= 0.
  std::shared_ptr<const DepthGrid> grid;  ///< replaces depth and slope; null: none.

  /// Height of the floor z [m] at (x, y), and its unit normal.
  struct Place
  {
    double z;
    Vector3 normal;
  };
  Place at(double x, double y) const;
  /// Depth [m] where waves feel it: at the origin, or the mean of the grid.
  double meanDepth() const;
};

/// Every bound of Seabed that `seabed` violates, one sentence each.
std::vector<std::string> validate(const Seabed& seabed);

}  // namespace tether_monitor::core
