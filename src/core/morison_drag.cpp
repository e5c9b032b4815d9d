#include "tether_monitor/core/morison_drag.h"

#include <Eigen/Dense>
#include <cmath>

namespace tether_monitor::core
{
namespace
{
constexpr double NO_DIRECTION = 1e-12;  // |r'| [-] below which a slope has no direction
constexpr double NO_SPEED = 1e-12;      // |un| [m/s] below which its direction is not used

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

DragLaw morisonDrag(double normal, double tangential, const Vector3& u, const Vector3& slope)
{
  const double inverse = inverseNorm(slope);
  const Vector3 t = slope * inverse;
  const double ut = t.dot(u);
  const double ut_abs = std::abs(ut);
  const Vector3 un = u - ut * t;
  const double speed = un.norm();
  const Matrix3 P = Matrix3::Identity() - t * t.transpose();
  const Vector3 e = speed > NO_SPEED ? Vector3(un / speed) : Vector3::Zero();

  DragLaw law;
  law.force = normal * speed * un + tangential * ut_abs * ut * t;
  const Matrix3 spread = speed * (P + e * e.transpose());
  const Matrix3 along = t * un.transpose();
  law.d_velocity = normal * spread + 2.0 * tangential * ut_abs * t * t.transpose();
  law.d_slope = inverse * (tangential * ut_abs * (2.0 * along + ut * P) - normal * (speed * along + ut * spread));
  return law;
}

}  // namespace tether_monitor::core
