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

// One integration point of an element, as a piece of the tether: rates are those of the material.
struct MaterialPoint
{
  Vector3 r, slope, slope_rate, v, a;
};

template <bool WITH_TANGENT>
void addAxial(const ElementParameters& p, const MaterialPoint& at, const TangentWeights& w, PointLoads& out)
{
  const double inverse = 1.0 / p.natural_stretch;
  const double strain = 0.5 * (inverse * inverse * at.slope.squaredNorm() - 1.0);  // (M2)
  const double strain_rate = inverse * inverse * at.slope.dot(at.slope_rate);
  const AxialLaw law = axialLaw(p.axial, strain);
  const double viscous = p.axial.damping * p.axial.stiffness;
  const double N = inverse * (law.force + viscous * strain_rate);  // (M3), (M5)
  out.n += N * at.slope;
  if constexpr (WITH_TANGENT)
  {
    const double cube = inverse * inverse * inverse;
    out.n_dr +=
        w.stiffness * N * Matrix3::Identity() +
        cube * at.slope *
            ((w.stiffness * law.modulus + w.damping * viscous) * at.slope + w.stiffness * viscous * at.slope_rate)
                .transpose();
  }
}

template <bool WITH_TANGENT>
void addAir(const ElementParameters& p, const Sea& sea, double dry_share, const MaterialPoint& at,
            const TangentWeights& w, PointLoads& out)
{
  const double half_rho_d = 0.5 * Sea::AIR_DENSITY * p.diameter * dry_share;
  const DragLaw drag =
      morisonDrag(half_rho_d * p.drag_normal, half_rho_d * p.drag_tangential, at.v - sea.wind(), at.slope);
  out.f += drag.force;
  if constexpr (WITH_TANGENT)
  {
    out.f_r += w.damping * drag.d_velocity;
    out.f_dr += w.stiffness * drag.d_slope;
  }
}

template <bool WITH_TANGENT>
void addWater(const ElementParameters& p, const Sea& sea, double piece, double time, const MaterialPoint& at,
              const TangentWeights& w, PointLoads& out)
{
  const Water water = sea.waterAt(at.r, time);
  const Submersion wet =
      submersion(at.r.z() - water.surface, std::abs(at.slope.z()) * piece + p.diameter);  // (M8)
  const double shrunk = at.r.z() < 0.0 ? std::max(1.0 + p.compression * at.r.z(), 0.1) : 1.0;
  const double displaced = sea.density() * p.area * shrunk * shrunk;
  out.f.z() += sea.gravity() * (p.mass - displaced * wet.share);
  if constexpr (WITH_TANGENT)
  {
    const double shrinking = at.r.z() < 0.0 ? 2.0 * p.compression / shrunk : 0.0;
    out.f_r(2, 2) += w.stiffness * sea.gravity() * displaced * (wet.slope - shrinking * wet.share);
  }
  if (wet.share < 1.0 && sea.hasWind())
    addAir<WITH_TANGENT>(p, sea, 1.0 - wet.share, at, w, out);
  if (wet.share <= 0.0)
    return;

  const double half_rho_d = 0.5 * sea.density() * p.diameter * shrunk * wet.share;
  const Vector3 u = at.v - water.velocity;
  const double added = displaced * p.added_mass * wet.share;
  const double inverse = 1.0 / std::max(at.slope.squaredNorm(), 1e-12);
  const Matrix3 normal_plane = Matrix3::Identity() - inverse * at.slope * at.slope.transpose();
  out.f += added * (normal_plane * (at.a - water.acceleration)) -
           displaced * wet.share * (normal_plane * water.acceleration);  // (M10)
  if constexpr (WITH_TANGENT)
  {
    const DragLaw drag =
        morisonDrag(half_rho_d * p.drag_normal, half_rho_d * p.drag_tangential, u, at.slope);  // (M9)
    out.f += drag.force;
    out.f_r += w.damping * drag.d_velocity + w.mass * added * normal_plane;
    out.f_dr += w.stiffness * drag.d_slope;
  }
  else
  {
    out.f += morisonDragForce(half_rho_d * p.drag_normal, half_rho_d * p.drag_tangential, u, at.slope);
  }
}

// Rates of the material where the tether runs through the mesh, (M24). Adds the inertia that the mass matrix
// misses.
template <bool WITH_TANGENT>
void addFlow(const ElementParameters& p, double xi, const ShapeValues& S, const ShapeValues& dS,
             const ElementMotion& m, const TangentWeights& w, MaterialPoint& at, PointLoads& out)
{
  const ElementFlow& flow = p.flow;
  const double c = flow.at(xi), g = flow.growth;
  const auto spread = [](const ShapeValues& shape, const ElementCoords& x)
  { return Vector3(shape[1] * x.segment<3>(3) + shape[3] * x.segment<3>(9)); };
  const Vector3 spread_slope = spread(S, m.q);
  const Vector3 turning = at.slope_rate + g * spread(dS, m.q) - g * at.slope;  // d r'/dt at the mesh point
  const Vector3 curvature = interpolate(shapeCurvatures(xi, p.length), m.q);
  const Vector3 extra = 2.0 * g * spread(S, m.v) + flow.acceleration * spread_slope + flow.rateAt(xi) * at.slope +
                        2.0 * c * turning + c * c * curvature;
  at.v += g * spread_slope + c * at.slope;
  at.slope_rate = turning + c * curvature;
  at.a += extra;
  out.f += p.mass * extra;
  if constexpr (WITH_TANGENT)
    out.f_dr += (2.0 * c * w.damping * p.mass) * Matrix3::Identity();
}

void addScaledBlocks(const ShapeMatrix& m, double scale, ElementMatrix& tangent)
{
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      tangent.block<3, 3>(3 * i, 3 * j).diagonal().array() += scale * m(i, j);
}

template <bool WITH_TANGENT>
void evaluate(const ElementParameters& p, const Sea& sea, const ElementMotion& m, const TangentWeights& w,
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
    MaterialPoint point_motion{interpolate(S, m.q), interpolate(dS, m.q), interpolate(dS, m.v),
                               interpolate(S, m.v), interpolate(S, m.a)};
    PointLoads at;
    if (p.flow.active)
      addFlow<WITH_TANGENT>(p, point.xi, S, dS, m, w, point_motion, at);
    addAxial<WITH_TANGENT>(p, point_motion, w, at);
    addWater<WITH_TANGENT>(p, sea, weight, m.time, point_motion, w, at);

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

void elementResidual(const ElementParameters& p, const Sea& sea, const ElementMotion& motion,
                     ElementCoords& residual)
{
  evaluate<false>(p, sea, motion, TangentWeights{}, residual, nullptr);
}

void elementResidual(const ElementParameters& p, const Sea& sea, const ElementMotion& motion,
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
    const double strain = 0.5 * (slope.squaredNorm() / (p.natural_stretch * p.natural_stretch) - 1.0);
    energy.axial += weight * p.natural_stretch * axialLaw(p.axial, strain).energy;
    energy.weight += weight * p.mass * gravity * interpolate(shapeFunctions(point.xi, p.length), q).z();
  }
  return energy;
}

}  // namespace tether_monitor::core
