#include "tether_monitor/core/solve/catenary.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
namespace
{
constexpr double WIDEST_SPAN = 0.6;  // share of the length to which a bight is opened for that at most

// x > 0 with sinh(x)/x = ratio > 1.
double solveSinhRatio(double ratio)
{
  double x =
      ratio < 3.0 ? std::sqrt(6.0 * (ratio - 1.0)) : std::log(2.0 * ratio) + std::log(std::log(2.0 * ratio));
  for (int i = 0; i < 60; ++i)
  {
    const double f = std::sinh(x) - ratio * x;
    const double step = f / (std::cosh(x) - ratio);
    x = std::max(x - step, 0.5 * x);
    if (std::abs(step) < 1e-14 * x)
      break;
  }
  return x;
}

Vector3 anyNormal(const Vector3& direction)
{
  const Vector3 other = std::abs(direction.x()) < 0.8 ? Vector3::UnitX() : Vector3::UnitY();
  return (other - other.dot(direction) * direction).normalized();
}
}  // namespace

Catenary::Catenary(const Vector3& from, const Vector3& to, double length, const Vector3& load, double least_radius)
  : from_(from), chord_(to - from), length_(length)
{
  const double chord = chord_.norm();
  down_ = load.norm() > 0.0 ? Vector3(load.normalized()) : Vector3(-Vector3::UnitZ());
  along_ = anyNormal(down_);
  if (chord >= length * (1.0 - 1e-9))
    return;
  const double drop = chord_.dot(down_);
  const Vector3 across = chord_ - drop * down_;
  double span = across.norm();
  if (span > 1e-9 * length)
    along_ = across / span;
  const double slack = std::sqrt(length * length - drop * drop);
  double x = solveSinhRatio(std::max(slack / std::max(span, 1e-6 * slack), 1.0 + 1e-12));
  while (span / (2.0 * x) < least_radius && span < WIDEST_SPAN * slack)
  {
    span = std::min(1.2 * span + 0.01 * slack, WIDEST_SPAN * slack);
    x = solveSinhRatio(slack / span);
  }
  parameter_ = span / (2.0 * x);
  vertex_ = 0.5 * (length + drop / std::tanh(x));
}

Vector3 Catenary::tangent(double s) const
{
  if (parameter_ <= 0.0)
    return chord_.norm() > 0.0 ? Vector3(chord_.normalized()) : along_;
  const double slope = (vertex_ - s) / parameter_;
  return (along_ + slope * down_).normalized();
}

Vector3 Catenary::position(double s) const
{
  if (parameter_ <= 0.0)
    return from_ + s / length_ * chord_;
  const double a = parameter_;
  const double u0 = vertex_ / a;
  const double u = (vertex_ - s) / a;
  return from_ + a * (std::asinh(u0) - std::asinh(u)) * along_ +
         a * (std::hypot(1.0, u0) - std::hypot(1.0, u)) * down_;
}

}  // namespace tether_monitor::core
