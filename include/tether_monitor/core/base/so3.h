#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// Rotation by the vector `turn`: about its direction, by its length [rad] (exponential map).
inline Eigen::Quaterniond expSO3(const Vector3& turn)
{
  const double angle = turn.norm();
  const double sine = angle > 1e-8 ? std::sin(0.5 * angle) / angle : 0.5;
  return {std::cos(0.5 * angle), sine * turn.x(), sine * turn.y(), sine * turn.z()};
}

/// The matrix of the cross product: skew(a) b = a x b.
inline Matrix3 skew(const Vector3& a)
{
  Matrix3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

}  // namespace tether_monitor::core
