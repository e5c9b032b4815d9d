#pragma once

#include <Eigen/Core>
#include <vector>

namespace tether_monitor::core
{
/// A point, velocity or force in the world frame (ENU, z up, z = 0 at the still water surface) [m, m/s, N].
using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;

/// Force and moment at the centre of mass of a body, in its axes [N, N m].
struct Wrench
{
  Vector3 force = Vector3::Zero();
  Vector3 torque = Vector3::Zero();

  template <class Archive>
  void serialize(Archive& a)
  {
    a(force, torque);
  }
};

/// Coordinates of one node, or their rates, or the conjugate forces. Rows 0-2: position r [m];
/// rows 3-5: slope r' = dr/ds [-] (conjugate: N m).
using NodeCoords = Eigen::Matrix<double, 6, 1>;
using NodeMatrix = Eigen::Matrix<double, 6, 6>;

/// Coordinates of one element: node a (smaller s, nearer the vessel) above node b.
using ElementCoords = Eigen::Matrix<double, 12, 1>;
using ElementMatrix = Eigen::Matrix<double, 12, 12>;

/// One NodeCoords for each node, from the vessel end (node 0) to the vehicle end (node N).
using NodeField = std::vector<NodeCoords>;

/// The slice of a node field that belongs to element `i` (nodes i and i + 1).
inline ElementCoords elementCoords(const NodeField& field, int i)
{
  ElementCoords e;
  e << field[i], field[i + 1];
  return e;
}

}  // namespace tether_monitor::core
