#include "tether_monitor/core/environment/obstacle.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
namespace
{
// Outside: the direction to the nearest point of a convex core; the normal turns as on a sphere about that point,
// but only in the directions that leave the point (free).
SignedDistance fromNearest(const Vector3& p, const Vector3& nearest, const Vector3& free)
{
  const Vector3 way = p - nearest;
  const double distance = way.norm();
  const Vector3 n = way / distance;
  Matrix3 turn = free.asDiagonal();
  turn -= n * n.transpose();
  return {distance, n, turn / distance};
}

SignedDistance sphere(double radius, const Vector3& p)
{
  const double r = p.norm();
  if (r < 1e-9)
    return {-radius, Vector3::UnitZ(), Matrix3::Zero()};
  const Vector3 n = p / r;
  return {r - radius, n, (Matrix3::Identity() - n * n.transpose()) / r};
}

SignedDistance cylinder(double radius, double half, const Vector3& p)
{
  const double r = std::hypot(p.x(), p.y());
  const Vector3 radial = r > 1e-9 ? Vector3(p.x() / r, p.y() / r, 0.0) : Vector3::UnitX();
  const double out_r = r - radius, out_z = std::abs(p.z()) - half;
  const double sign = p.z() < 0.0 ? -1.0 : 1.0;
  const Vector3 around(-radial.y(), radial.x(), 0.0);
  if (out_r > 0.0 && out_z > 0.0)
  {
    const double distance = std::hypot(out_r, out_z);
    const Vector3 n = (out_r * radial + sign * out_z * Vector3::UnitZ()) / distance;
    const Vector3 along = n.cross(around);
    return {distance, n,
            along * along.transpose() / distance + around * around.transpose() * (out_r / distance / r)};
  }
  if (out_r > out_z)
    return {out_r, radial, r > 1e-9 ? Matrix3(around * around.transpose() / r) : Matrix3::Zero()};
  return {out_z, sign * Vector3::UnitZ(), Matrix3::Zero()};
}

SignedDistance box(const Vector3& half, const Vector3& p)
{
  const Vector3 nearest = p.cwiseMax(-half).cwiseMin(half);
  const Vector3 free = (p - nearest).unaryExpr([](double x) { return x != 0.0 ? 1.0 : 0.0; });
  if (free.norm() > 0.0)
    return fromNearest(p, nearest, free);
  Eigen::Index axis;
  const double depth = (p.cwiseAbs() - half).maxCoeff(&axis);
  return {depth, (p[axis] < 0.0 ? -1.0 : 1.0) * Vector3::Unit(axis), Matrix3::Zero()};
}
}  // namespace

std::vector<std::string> validate(const Obstacle& obstacle, const std::string& prefix)
{
  BoundsCheck check(prefix);
  const int sizes = obstacle.shape == ObstacleShape::SPHERE     ? 1
                    : obstacle.shape == ObstacleShape::CYLINDER ? 2
                                                                : 3;
  for (int i = 0; i < sizes; ++i)
    check.positive(("size[" + std::to_string(i) + "]").c_str(), obstacle.size[i], "m");
  check.finite("position (norm)", obstacle.position.norm(), "m");
  check.finite("velocity (norm)", obstacle.velocity.norm(), "m/s");
  check.notNegative("mass", obstacle.mass, "kg");
  check.notNegative("friction", obstacle.friction, "[-]");
  check.positive("stiffness", obstacle.stiffness, "N/m^3");
  const double norm = obstacle.orientation.norm();
  check.check(std::abs(norm - 1.0) < 0.01, "orientation (norm)", norm, "1");
  return check.problems();
}

SignedDistance signedDistance(const Obstacle& obstacle, const Vector3& offset)
{
  if (obstacle.shape == ObstacleShape::SPHERE)
    return sphere(obstacle.size[0], offset);
  const Matrix3 R = obstacle.orientation.toRotationMatrix();
  const Vector3 p = R.transpose() * offset;
  SignedDistance local = obstacle.shape == ObstacleShape::CYLINDER
                             ? cylinder(obstacle.size[0], 0.5 * obstacle.size[1], p)
                             : box(0.5 * obstacle.size, p);
  return {local.distance, R * local.normal, R * local.curvature * R.transpose()};
}

double enclosingRadius(const Obstacle& obstacle)
{
  switch (obstacle.shape)
  {
    case ObstacleShape::SPHERE:
      return obstacle.size[0];
    case ObstacleShape::CYLINDER:
      return std::hypot(obstacle.size[0], 0.5 * obstacle.size[1]);
    case ObstacleShape::BOX:
      break;
  }
  return 0.5 * obstacle.size.norm();
}

}  // namespace tether_monitor::core
