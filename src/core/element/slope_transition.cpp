#include "tether_monitor/core/element/slope_transition.h"

#include <algorithm>
#include <cmath>

namespace tether_monitor::core
{
namespace
{
constexpr double NO_LENGTH = 1e-12;

// Tension x N(eps) of a stretch x >= 1, and its derivatives.
struct Tension
{
  Tension(const AxialParameters& p, double x)
  {
    const AxialResponse<double> law = axialResponse(p, strainOfStretch(x));
    value = x * law.force;
    slope = law.force + x * x * law.modulus;
    curvature = 3.0 * x * law.modulus;
  }
  double value, slope, curvature;
};
}  // namespace

SlopeMap::SlopeMap(const SlopeTransition& transition, const Vector3& node_slope)
  : g_(node_slope), length_(std::max(node_slope.norm(), NO_LENGTH))
{
  unit_ = g_ / length_;
  const double rho = transition.active ? transition.softer.stiffness / transition.own.stiffness : 1.0;
  const double scale = 1.0 / transition.neighbour_stretch, x = scale * length_;
  double ratio = 1.0 + (1.0 - rho) * (1.0 - x), slope = rho - 1.0, curvature = 0.0;  // y / x and its derivatives
  if (transition.active && x > 1.0)
  {
    const Tension here(transition.softer, x);
    const double y = stretchAtTension(transition.own, here.value);
    const Tension there(transition.own, y);
    const double dy = here.slope / there.slope;
    const double ddy = (here.curvature - there.curvature * dy * dy) / there.slope;
    ratio = y / x;
    slope = (dy - ratio) / x;
    curvature = (ddy - 2.0 * slope) / x;
  }
  const double natural = transition.own_stretch * scale;
  h_ = natural * ratio;
  dh_ = natural * scale * slope;
  ddh_ = natural * scale * scale * curvature;
}

Vector3 SlopeMap::rate(const Vector3& rate) const
{
  return h_ * rate + dh_ * unit_.dot(rate) * g_;
}

Vector3 SlopeMap::acceleration(const Vector3& rate, const Vector3& acceleration) const
{
  const double along = unit_.dot(rate);
  const double across_square = std::max(rate.squaredNorm() - along * along, 0.0);
  return this->rate(acceleration) + 2.0 * dh_ * along * rate +
         (ddh_ * along * along + dh_ * across_square / length_) * g_;
}

Matrix3 SlopeMap::jacobian() const
{
  return h_ * Matrix3::Identity() + dh_ * length_ * unit_ * unit_.transpose();
}

Matrix3 SlopeMap::geometricStiffness(const Vector3& force) const
{
  const double along = unit_.dot(force);
  const Matrix3 unit_force = unit_ * force.transpose();
  return dh_ * (unit_force + unit_force.transpose() + along * Matrix3::Identity()) +
         (ddh_ * length_ - dh_) * along * unit_ * unit_.transpose();
}

}  // namespace tether_monitor::core
