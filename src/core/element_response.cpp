#include "tether_monitor/core/element_response.h"

#include <Eigen/Dense>

#include "tether_monitor/core/buoyancy.h"
#include "tether_monitor/core/morison_drag.h"
#include "tether_monitor/core/quadrature.h"
#include "tether_monitor/core/shape_functions.h"

namespace tether_monitor::core
{
namespace
{
// Loads at one integration point: f is conjugate to r, n to r'.
struct PointLoads
{
  Vector3 f = Vector3::Zero();
  Vector3 n = Vector3::Zero();
  Matrix3 f_r = Matrix3::Zero();   // weighted df/dr
  Matrix3 f_dr = Matrix3::Zero();  // weighted df/dr'
  Matrix3 n_dr = Matrix3::Zero();  // weighted dn/dr'
};

template <bool WITH_TANGENT>
void addAxial(const ElementParameters& p, const Vector3& slope, const Vector3& slope_rate, const TangentWeights& w,
              PointLoads& out)
{
  const double strain = 0.5 * (slope.squaredNorm() - 1.0);  // (M2)
  const double strain_rate = slope.dot(slope_rate);
  const AxialLaw law = axialLaw(p.axial, strain);
  const double N = law.force + p.axial.damping * p.axial.stiffness * strain_rate;  // (M3), (M5)
  out.n += N * slope;
  if constexpr (WITH_TANGENT)
  {
    const double viscous = p.axial.damping * p.axial.stiffness;
    out.n_dr +=
        w.stiffness * N * Matrix3::Identity() +
        slope * ((w.stiffness * law.modulus + w.damping * viscous) * slope + w.stiffness * viscous * slope_rate)
                    .transpose();
  }
}

template <bool WITH_TANGENT>
void addWater(const ElementParameters& p, const Environment& sea, double piece, const Vector3& r,
              const Vector3& slope, const Vector3& v, const Vector3& a, const TangentWeights& w, PointLoads& out)
{
  const Submersion wet = submersion(r.z(), std::abs(slope.z()) * piece + p.diameter);  // (M8)
  const double displaced = sea.water_density * p.area;
  out.f.z() += sea.gravity * (p.mass - displaced * wet.share);
  if constexpr (WITH_TANGENT)
    out.f_r(2, 2) += w.stiffness * sea.gravity * displaced * wet.slope;
  if (wet.share <= 0.0)
    return;

  const double half_rho_d = 0.5 * sea.water_density * p.diameter * wet.share;
  const Vector3 u = v - sea.waterVelocity(r);
  const double added = displaced * p.added_mass * wet.share;
  const double inverse = 1.0 / std::max(slope.squaredNorm(), 1e-12);
  const Matrix3 normal_plane = Matrix3::Identity() - inverse * slope * slope.transpose();
  out.f += added * (normal_plane * a);  // (M10)
  if constexpr (WITH_TANGENT)
  {
    const DragLaw drag =
        morisonDrag(half_rho_d * p.drag_normal, half_rho_d * p.drag_tangential, u, slope);  // (M9)
    out.f += drag.force;
    out.f_r += w.damping * drag.d_velocity + w.mass * added * normal_plane;
    out.f_dr += w.stiffness * drag.d_slope;
  }
  else
  {
    out.f += morisonDragForce(half_rho_d * p.drag_normal, half_rho_d * p.drag_tangential, u, slope);
  }
}

void addScaledBlocks(const ShapeMatrix& m, double scale, ElementMatrix& tangent)
{
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      tangent.block<3, 3>(3 * i, 3 * j).diagonal().array() += scale * m(i, j);
}

template <bool WITH_TANGENT>
void evaluate(const ElementParameters& p, const Environment& sea, const ElementMotion& m, const TangentWeights& w,
              ElementCoords& residual, ElementMatrix* tangent)
{
  // The linear terms: inertia (M7) and bending (M6), the same for the three components of the world.
  for (int i = 0; i < 4; ++i)
  {
    residual.segment<3>(3 * i).setZero();
    for (int j = 0; j < 4; ++j)
      residual.segment<3>(3 * i) +=
          p.mass_matrix(i, j) * m.a.segment<3>(3 * j) + p.bending_matrix(i, j) * m.q.segment<3>(3 * j);
  }
  if constexpr (WITH_TANGENT)
  {
    tangent->setZero();
    addScaledBlocks(p.mass_matrix, w.mass, *tangent);
    addScaledBlocks(p.bending_matrix, w.stiffness, *tangent);
  }
  for (const GaussPoint& point : GAUSS_POINTS)
  {
    const ShapeValues S = shapeFunctions(point.xi, p.length);
    const ShapeValues dS = shapeSlopes(point.xi, p.length);
    const double weight = point.weight * p.length;
    const Vector3 slope = interpolate(dS, m.q);

    PointLoads at;
    addAxial<WITH_TANGENT>(p, slope, interpolate(dS, m.v), w, at);
    addWater<WITH_TANGENT>(p, sea, weight, interpolate(S, m.q), slope, interpolate(S, m.v), interpolate(S, m.a), w,
                           at);

    for (int i = 0; i < 4; ++i)
    {
      residual.segment<3>(3 * i) += weight * (S[i] * at.f + dS[i] * at.n);
      if constexpr (WITH_TANGENT)
        for (int j = 0; j < 4; ++j)
          tangent->block<3, 3>(3 * i, 3 * j) +=
              weight * (S[i] * S[j] * at.f_r + S[i] * dS[j] * at.f_dr + dS[i] * dS[j] * at.n_dr);
    }
  }
}
}  // namespace

void elementResidual(const ElementParameters& p, const Environment& sea, const ElementMotion& motion,
                     ElementCoords& residual)
{
  evaluate<false>(p, sea, motion, TangentWeights{}, residual, nullptr);
}

void elementResidual(const ElementParameters& p, const Environment& sea, const ElementMotion& motion,
                     const TangentWeights& weights, ElementCoords& residual, ElementMatrix& tangent)
{
  evaluate<true>(p, sea, motion, weights, residual, &tangent);
}

ElementEnergy elementEnergy(const ElementParameters& p, double gravity, const ElementCoords& q,
                            const ElementCoords& v)
{
  ElementEnergy energy{0.0, 0.0, 0.0, 0.0};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
    {
      energy.bending += 0.5 * p.bending_matrix(i, j) * q.segment<3>(3 * i).dot(q.segment<3>(3 * j));
      energy.kinetic += 0.5 * p.mass_matrix(i, j) * v.segment<3>(3 * i).dot(v.segment<3>(3 * j));
    }
  for (const GaussPoint& point : GAUSS_POINTS)
  {
    const double weight = point.weight * p.length;
    const Vector3 slope = interpolate(shapeSlopes(point.xi, p.length), q);
    energy.axial += weight * axialLaw(p.axial, 0.5 * (slope.squaredNorm() - 1.0)).energy;
    energy.weight += weight * p.mass * gravity * interpolate(shapeFunctions(point.xi, p.length), q).z();
  }
  return energy;
}

}  // namespace tether_monitor::core
