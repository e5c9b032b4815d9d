#include "tether_monitor/core/element/morison_drag.h"

#include <Eigen/Dense>
#include <cmath>

namespace tether_monitor::core
{
namespace
{
constexpr double NO_DIRECTION = 1e-12;  // |r'| [-] below which a slope has no direction

double inverseNorm(const Vector3& slope)
{
  const double norm = slope.norm();
  return norm > NO_DIRECTION ? 1.0 / norm : 0.0;
}
}  // namespace

Vector3 morisonDragForce(double normal, double tangential, const Vector3& u, const Vector3& slope)
{
  const Vector3 t = slope * inverseNorm(slope);
  const double ut = t.dot(u);
  const Vector3 un = u - ut * t;
  return normal * un.norm() * un + tangential * std::abs(ut) * ut * t;  // (M9)
}

}  // namespace tether_monitor::core
