#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// Shapes that a tether can meet; the numbers are those of Obstacle.msg.
enum class ObstacleShape
{
  SPHERE = 0,
  CYLINDER = 1,
  BOX = 2
};

/// A solid that the tether may touch. It translates; it does not turn.
struct Obstacle
{
  std::string name;
  ObstacleShape shape = ObstacleShape::SPHERE;
  Vector3 position = Vector3::Zero();  ///< of its centre, world [m], when it becomes known.
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();  ///< its axes to the world, unit.
  Vector3 size = Vector3::Zero();      ///< radius | radius, length along its z | lx, ly, lz [m], those used > 0.
  Vector3 velocity = Vector3::Zero();  ///< [m/s]; constant, with a mass only at first.
  double mass = 0.0;                   ///< [kg], >= 0; 0: the tether does not move it.
  double friction = 0.0;               ///< Coulomb's mu [-], >= 0.
  double stiffness = 1.0e8;            ///< k [N/m^3], > 0: force per metre of tether k d * penetration.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(name, shape, position, orientation, size, velocity, mass, friction, stiffness);
  }
};

/// Every bound of Obstacle that `obstacle` violates, one sentence each, beginning with `prefix`.
std::vector<std::string> validate(const Obstacle& obstacle, const std::string& prefix);

/// Distance of a point from a surface, < 0 inside, and the outward unit normal at the nearest surface point.
struct SignedDistance
{
  double distance;  ///< [m]
  Vector3 normal;
  Matrix3 curvature;  ///< d normal / d point [1/m].
};

/**
 * Distance of a point from the surface of an obstacle.
 *
 * @param offset  the point minus the centre of the obstacle, world axes [m].
 */
SignedDistance signedDistance(const Obstacle& obstacle, const Vector3& offset);

/// Radius of a sphere about the centre that holds the whole obstacle [m].
double enclosingRadius(const Obstacle& obstacle);

}  // namespace tether_monitor::core
