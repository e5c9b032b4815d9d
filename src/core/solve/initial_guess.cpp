#include "tether_monitor/core/solve/initial_guess.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "tether_monitor/core/bodies/rigid_body_dynamics.h"
#include "tether_monitor/core/element/morison_drag.h"
#include "tether_monitor/core/solve/catenary.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LEAST_RADIUS = 0.3;  // of a bight, in elements: a tighter one would be folded by the mesh

// Weight and drag per metre on a tether element at place r with direction t.
Vector3 loadAt(const ElementParameters& e, const EnvironmentModel& environment, const Vector3& r, const Vector3& t,
               const Vector3& velocity)
{
  const double share = r.z() < 0.0 ? 1.0 : 0.0;
  const double half_rho_d = 0.5 * environment.density() * e.diameter * share;
  Vector3 load = -morisonDragForce(half_rho_d * e.drag_normal, half_rho_d * e.drag_tangential,
                                   Vector3(velocity - environment.waterKinematics(r, 0.0).velocity), t);
  load.z() -= environment.gravity() * (e.mass - environment.density() * e.area * share);
  return load;
}
}  // namespace

Vector3 netLoad(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle, const Vector3& velocity)
{
  const EnvironmentModel& environment = cable.environment();
  Vector3 load = Vector3::Zero();
  constexpr int SAMPLES = 8;
  for (int i = 0; i < SAMPLES; ++i)
  {
    const Vector3 r = vessel + (i + 0.5) / SAMPLES * (vehicle - vessel);
    load += loadAt(cable.element(i * cable.elements() / SAMPLES), environment, r, vehicle - vessel, velocity);
  }
  load /= SAMPLES;
  for (const LumpedAttachment& point : cable.model().lumpedAttachments())
  {
    const Vector3 place = vessel + cable.arcLength(point.node) / cable.length() * (vehicle - vessel);
    load -= lumpedAttachmentResidual(point, environment, 0.0, {place, velocity, Vector3::Zero()}) / cable.length();
  }
  return load;
}

NodeField catenaryGuess(const DeployedCable& cable, const Vector3& vessel, const Vector3& vehicle,
                        const Vector3& velocity)
{
  const double L = cable.length();
  const Vector3 load = netLoad(cable, vessel, vehicle, velocity);
  const Catenary curve(vessel, vehicle, L, load, LEAST_RADIUS * L / cable.elements());
  const Vector3 gap = vehicle - curve.position(L);  // left where the bight was opened
  const double stretch = std::max(1.0, (vehicle - vessel).norm() / L);
  NodeField shape(cable.nodes());
  for (int i = 0; i < cable.nodes(); ++i)
  {
    const double s = cable.arcLength(i);
    shape[i] << curve.position(s) + s / L * gap, stretch * curve.tangent(s);
  }
  return shape;
}

NodeField hangingBodyGuess(const DeployedCable& cable, const Vector3& vessel, const Vector3& velocity,
                           const RigidBody& body)
{
  constexpr int PASSES = 4;
  constexpr int PARTS = 10;  // of an element
  const int N = cable.elements();
  NodeField shape(cable.nodes());
  Vector3 body_position = vessel - cable.length() * Vector3::UnitZ();
  const auto direction = [&](const Vector3& tension)
  {
    return tension.norm() > 1e-9 * cable.forceScale() ? Vector3(tension.normalized()) : Vector3(-Vector3::UnitZ());
  };
  for (int pass = 0; pass < PASSES; ++pass)
  {
    Vector3 n = steadyForce(body, cable.environment(), body_position, velocity);
    Vector3 r = body_position;
    for (int i = N; i >= 0; --i)
    {
      const ElementParameters& e = cable.element(std::max(i - 1, 0));
      for (const LumpedAttachment& load : cable.model().lumpedAttachments())
        if (load.node == i)
          n -= lumpedAttachmentResidual(load, cable.environment(), 0.0, {r, velocity, Vector3::Zero()});
      shape[i] << r, stretchAtTension(e.axial, n.norm()) * direction(n);
      for (int part = 0; part < PARTS && i > 0; ++part)
      {
        const double ds = e.length / PARTS;
        const Vector3 middle = n + 0.5 * ds * loadAt(e, cable.environment(), r, direction(n), velocity);
        const Vector3 t = direction(middle);
        n += ds * loadAt(e, cable.environment(), r - 0.5 * ds * t, t, velocity);
        r -= ds * stretchAtTension(e.axial, middle.norm()) * t;
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
