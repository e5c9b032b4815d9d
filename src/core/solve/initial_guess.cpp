#include "tether_monitor/core/solve/initial_guess.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/element/morison_drag.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LEAST_RADIUS = 0.3;  // of a bight, in elements: a tighter one would be folded by the mesh
constexpr double WIDEST_SPAN = 0.6;   // share of the length to which a bight is opened for that at most

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

// Weight and drag per metre on a tether element at place r with direction t.
Vector3 loadAt(const ElementParameters& e, const EnvironmentModel& sea, const Vector3& r, const Vector3& t,
               const Vector3& velocity)
{
  const double share = r.z() < 0.0 ? 1.0 : 0.0;
  const double half_rho_d = 0.5 * sea.density() * e.diameter * share;
  Vector3 load = -morisonDragForce(half_rho_d * e.drag_normal, half_rho_d * e.drag_tangential,
                                   velocity - sea.waterKinematics(r, 0.0).velocity, t);
  load.z() -= sea.gravity() * (e.mass - sea.density() * e.area * share);
  return load;
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

Vector3 netLoad(const CableModel& model, const Vector3& vessel, const Vector3& vehicle, const Vector3& velocity)
{
  const EnvironmentModel& sea = model.sea();
  Vector3 load = Vector3::Zero();
  constexpr int SAMPLES = 8;
  for (int i = 0; i < SAMPLES; ++i)
  {
    const Vector3 r = vessel + (i + 0.5) / SAMPLES * (vehicle - vessel);
    load += loadAt(model.element(i * model.elements() / SAMPLES), sea, r, vehicle - vessel, velocity);
  }
  load /= SAMPLES;
  for (const LumpedAttachment& point : model.lumpedAttachments())
    load -= lumpedAttachmentResidual(point, sea, 0.0,
                                     vessel + model.arcLength(point.node) / model.length() * (vehicle - vessel),
                                     velocity, Vector3::Zero(), TangentWeights{}, nullptr) /
            model.length();
  return load;
}

NodeField catenaryGuess(const CableModel& model, const Vector3& vessel, const Vector3& vehicle,
                        const Vector3& velocity)
{
  const double L = model.length();
  const Vector3 load = netLoad(model, vessel, vehicle, velocity);
  const Catenary curve(vessel, vehicle, L, load, LEAST_RADIUS * L / model.elements());
  const Vector3 gap = vehicle - curve.position(L);  // left where the bight was opened
  const double stretch = std::max(1.0, (vehicle - vessel).norm() / L);
  NodeField shape(model.nodes());
  for (int i = 0; i < model.nodes(); ++i)
  {
    const double s = model.arcLength(i);
    shape[i] << curve.position(s) + s / L * gap, stretch * curve.tangent(s);
  }
  return shape;
}

NodeField hangingBodyGuess(const CableModel& model, const Vector3& vessel, const Vector3& velocity,
                           const RigidBody& body)
{
  constexpr int PASSES = 4;
  constexpr int PARTS = 10;  // of an element
  const int N = model.elements();
  NodeField shape(model.nodes());
  Vector3 body_position = vessel - model.length() * Vector3::UnitZ();
  const auto direction = [&](const Vector3& tension)
  {
    return tension.norm() > 1e-9 * model.forceScale() ? Vector3(tension.normalized()) : Vector3(-Vector3::UnitZ());
  };
  for (int pass = 0; pass < PASSES; ++pass)
  {
    Vector3 n = steadyForce(body, model.sea(), body_position, velocity);
    Vector3 r = body_position;
    for (int i = N; i >= 0; --i)
    {
      const ElementParameters& e = model.element(std::max(i - 1, 0));
      for (const LumpedAttachment& load : model.lumpedAttachments())
        if (load.node == i)
          n -= lumpedAttachmentResidual(load, model.sea(), 0.0, r, velocity, Vector3::Zero(), TangentWeights{},
                                        nullptr);
      shape[i] << r, (1.0 + n.norm() / e.axial.stiffness) * direction(n);
      for (int part = 0; part < PARTS && i > 0; ++part)
      {
        const double ds = e.length / PARTS;
        const Vector3 middle = n + 0.5 * ds * loadAt(e, model.sea(), r, direction(n), velocity);
        const Vector3 t = direction(middle);
        n += ds * loadAt(e, model.sea(), r - 0.5 * ds * t, t, velocity);
        r -= ds * (1.0 + middle.norm() / e.axial.stiffness) * t;
      }
    }
    const Vector3 shift = vessel - shape[0].head<3>();
    for (NodeCoords& node : shape)
      node.head<3>() += shift;
    body_position += shift;
  }
  return shape;
}

}  // namespace tether_monitor::core
