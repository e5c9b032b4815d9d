#include "tether_monitor/core/assembly/clamped_end.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace tether_monitor::core
{
namespace
{
constexpr double NO_LENGTH = 1e-12;
}

double ClampedEnd::energy(const Vector3& slope) const
{
  return isHinged() ? 0.0 : stiffness * (1.0 - direction.dot(slope) / std::max(slope.norm(), NO_LENGTH));
}

Vector3 ClampedEnd::residual(const Vector3& slope) const
{
  if (isHinged())
    return Vector3::Zero();
  const double length = std::max(slope.norm(), NO_LENGTH);
  const Vector3 t = slope / length;
  return -stiffness / length * (direction - direction.dot(t) * t);
}

Matrix3 ClampedEnd::tangent(const Vector3& slope) const
{
  if (isHinged())
    return Matrix3::Zero();
  const double length = std::max(slope.norm(), NO_LENGTH);
  const Vector3 t = slope / length;
  const double along = direction.dot(t);
  const Vector3 across = direction - along * t;
  return stiffness / (length * length) *
         (along * (Matrix3::Identity() - t * t.transpose()) + t * across.transpose() + across * t.transpose());
}

Vector3 ClampedEnd::moment(const Vector3& slope) const
{
  return isHinged() ? Vector3(Vector3::Zero())
                    : Vector3(stiffness * direction.cross(slope) / std::max(slope.norm(), NO_LENGTH));
}

}  // namespace tether_monitor::core
