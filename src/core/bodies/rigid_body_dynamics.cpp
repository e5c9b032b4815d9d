#include "tether_monitor/core/bodies/rigid_body.h"

#include <algorithm>
#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"
#include "tether_monitor/core/element/submergence.h"

namespace tether_monitor::core
{
namespace
{
constexpr double FRICTION_REGULARISATION_SPEED =
    0.01;  // speed at which half of the friction on a landed body acts [m/s]
constexpr int COLUMNS_ALONG = 8, COLUMNS_ACROSS = 4;  // of a hull

// Buoyancy of a body: force along z of the world and its moment about the centre of mass, world axes.
struct Hydrostatics
{
  double force = 0.0;
  Vector3 moment = Vector3::Zero();
  double share = 0.0;                     // of the body under water
  double volume = 0.0;                    // under water [m^3]
  double stiffness = 0.0;                 // -d force / dz
  Vector3 force_turn = Vector3::Zero();   // d force / d rotation in world axes
  Vector3 moment_rise = Vector3::Zero();  // d moment / dz
  Matrix3 moment_turn = Matrix3::Zero();  // d moment / d rotation in world axes
};

void addColumn(double weight, double wet, bool pierces, const Vector3& arm, double area, Hydrostatics& lift)
{
  // A column of water of height `wet` over an area, its centre at `arm`: pushes up with rho g area wet.
  const double force = weight * area * wet;
  const Vector3 moment(arm.y(), -arm.x(), 0.0);  // arm x z
  lift.force += force;
  lift.volume += area * wet;
  lift.moment += force * moment;
  const double stiffness = pierces ? weight * area : 0.0;
  lift.stiffness += stiffness;
  // A rotation moves the column by turn x arm; its height above the old place is moment' of the turn.
  lift.force_turn -= stiffness * moment;
  lift.moment_rise -= stiffness * moment;
  lift.moment_turn -= stiffness * moment * moment.transpose();
  // d(arm x z) / d turn = (turn x arm) x z.
  lift.moment_turn += force * (arm * Vector3::UnitZ().transpose() - arm.z() * Matrix3::Identity());
}

Hydrostatics hullHydrostatics(const Hull& hull, const EnvironmentModel& sea, double t, const Vector3& centre,
                              const Matrix3& R)
{
  Hydrostatics lift;
  const double weight = sea.density() * sea.gravity();
  const double area = hull.size.x() * hull.size.y() / (COLUMNS_ALONG * COLUMNS_ACROSS);
  for (int i = 0; i < COLUMNS_ALONG; ++i)
    for (int j = 0; j < COLUMNS_ACROSS; ++j)
    {
      const Vector3 foot = hull.keel + Vector3(((i + 0.5) / COLUMNS_ALONG - 0.5) * hull.size.x(),
                                               ((j + 0.5) / COLUMNS_ACROSS - 0.5) * hull.size.y(), 0.0);
      const Vector3 below = R * foot;
      const double surface = sea.wave().isCalm()
                                 ? 0.0
                                 : sea.wave().elevation(centre.x() + below.x() + sea.origin().x(),
                                                        centre.y() + below.y() + sea.origin().y(), t);
      const double depth = surface - (centre.z() + below.z());
      const double wet = std::clamp(depth, 0.0, hull.size.z());
      if (wet > 0.0)
        addColumn(weight, wet, wet < hull.size.z(), R * (foot + 0.5 * wet * Vector3::UnitZ()), area, lift);
    }
  lift.share = std::clamp(lift.volume / (hull.size.prod() * 0.5), 0.0, 1.0);
  return lift;
}

Hydrostatics volumeHydrostatics(const RigidBody& body, const EnvironmentModel& sea, double surface,
                                const Vector3& centre, const Matrix3& R)
{
  Hydrostatics lift;
  const double extent = std::cbrt(body.volume) + 1e-6;
  const Submergence wet = submergence(centre.z() - surface, extent);
  const double whole = sea.density() * sea.gravity() * body.volume;
  addColumn(whole, wet.share, false, R * body.center_of_buoyancy, 1.0, lift);
  const Vector3 moment(lift.moment);
  lift.volume = body.volume * wet.share;
  lift.share = wet.share;
  lift.stiffness = whole * wet.slope;
  if (wet.share > 0.0)
    lift.moment_rise = -moment * (wet.slope / wet.share);
  return lift;
}

Hydrostatics hydrostaticsOf(const RigidBody& body, const EnvironmentModel& sea, double t, double surface,
                            const Vector3& centre, const Matrix3& R)
{
  return body.hull ? hullHydrostatics(*body.hull, sea, t, centre, R)
                   : volumeHydrostatics(body, sea, surface, centre, R);
}

// The seabed under a body, as under a ball of its volume: force on the body and its weighted stiffness, world
// axes.
struct SeabedReaction
{
  Vector3 force = Vector3::Zero();
  Matrix3 stiffness = Matrix3::Zero();
};

SeabedReaction seabedReaction(const RigidBody& body, const EnvironmentModel& sea, const Vector3& centre,
                              const Vector3& velocity, const TangentWeights& w)
{
  SeabedReaction out;
  const double radius = 0.5 * std::cbrt(body.volume);
  const Seabed::Place floor = sea.floorAt(centre);
  const double penetration = radius - (centre.z() - floor.z) * floor.normal.z();
  if (penetration <= 0.0)
    return out;
  const Seabed& bed = *sea.environment().seabed;
  const double area = M_PI * radius * radius;
  const double share = std::min(penetration / (0.1 * radius), 1.0);  // the damper comes in softly
  const double N = area * (bed.normal_stiffness * penetration - share * bed.damping * floor.normal.dot(velocity));
  if (N <= 0.0)
    return out;
  const Matrix3 P = Matrix3::Identity() - floor.normal * floor.normal.transpose();
  const Vector3 slide = P * velocity;
  const double slow = slide.norm() + FRICTION_REGULARISATION_SPEED;
  out.force = N * floor.normal - bed.friction * N / slow * slide;
  out.stiffness = area * (w.stiffness * bed.normal_stiffness + w.damping * share * bed.damping) * floor.normal *
                      floor.normal.transpose() +
                  w.damping * bed.friction * N / slow * P;
  return out;
}

// c_i |u| u_i and its derivative.
Vector3 quadraticDrag(const Vector3& c, const Vector3& u, Matrix3& derivative)
{
  const double speed = u.norm();
  const Vector3 cu = c.cwiseProduct(u);
  derivative = (speed * c).asDiagonal();
  if (speed > 0.0)
    derivative += cu * u.transpose() / speed;
  return speed * cu;
}
}  // namespace

Matrix3 skew(const Vector3& a)
{
  Matrix3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

std::vector<std::string> validate(const RigidBody& body, const std::string& prefix)
{
  BoundsCheck check(prefix);
  check.positive("mass", body.mass, "kg");
  check.notNegative("volume", body.volume, "m^3");
  const auto each = [&](const char* name, const Vector3& v, bool positive)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::string entry = std::string(name) + "[" + std::to_string(i) + "]";
      check.check(std::isfinite(v[i]) && (positive ? v[i] > 0.0 : v[i] >= 0.0), entry.c_str(), v[i],
                  positive ? "> 0" : ">= 0");
    }
  };
  each("inertia", body.inertia, true);
  each("drag_area", body.drag_area, false);
  each("added_mass", body.added_mass, false);
  each("added_inertia", body.added_inertia, false);
  each("rotational_drag", body.rotational_drag, false);
  each("wind_area", body.wind_area, false);
  check.finite("center_of_buoyancy (norm)", body.center_of_buoyancy.norm(), "m");
  check.finite("force (norm)", body.force.norm(), "N");
  check.finite("attachment (norm)", body.attachment.norm(), "m");
  if (body.hull)
  {
    each("hull.size", body.hull->size, true);
    check.finite("hull.keel (norm)", body.hull->keel.norm(), "m");
  }
  return check.problems();
}

RigidBodyResidual rigidBodyResidual(const RigidBody& body, const EnvironmentModel& sea, double t,
                                    const AttachmentMotion& node, const AttitudeState& rotation,
                                    const Wrench& thrust, const TangentWeights& wt)
{
  const Matrix3 R = rotation.orientation.toRotationMatrix();
  const Vector3& p = body.attachment;
  const Vector3& w = rotation.velocity;
  const Vector3& alpha = rotation.acceleration;
  const Vector3 centre = node.position - R * p;
  const WaterKinematics water = sea.waterKinematics(centre, t);
  const Hydrostatics lift = hydrostaticsOf(body, sea, t, water.surface, centre, R);

  // Everything in body axes: acceleration of the centre of mass, velocity and acceleration relative to the water.
  const Vector3 swing = alpha.cross(p) + w.cross(w.cross(p));
  const Vector3 node_a = R.transpose() * node.acceleration;
  const Vector3 water_a = R.transpose() * water.acceleration;
  const Vector3 node_u = R.transpose() * (node.velocity - water.velocity);
  const Vector3 a = node_a - swing;
  const Vector3 u = node_u - w.cross(p);
  const Vector3 Ma = lift.share * body.added_mass, Ja = lift.share * body.added_inertia;
  const Vector3 Mu = Ma.cwiseProduct(u);
  Matrix3 g_u, m_w;
  const Vector3 drag = quadraticDrag(0.5 * sea.density() * lift.share * body.drag_area, u, g_u);

  const Vector3 J = body.inertia + Ja;
  const Vector3 Jw = J.cwiseProduct(w);
  const Vector3 spin_drag = quadraticDrag(lift.share * body.rotational_drag, w, m_w);

  // Force that the body needs, body axes: inertia, added inertia (Kirchhoff), drag, less thrust and the wave's
  // push.
  Vector3 g = body.mass * a + Ma.cwiseProduct(a - water_a - w.cross(u)) + w.cross(Mu) + drag - thrust.force -
              sea.density() * lift.volume * water_a;
  const double dry_share = body.hull ? 1.0 : 1.0 - lift.share;
  const Vector3 node_air = R.transpose() * (node.velocity - sea.wind());
  Matrix3 g_air = Matrix3::Zero();
  if (body.wind_area.squaredNorm() > 0.0)
    g += quadraticDrag(0.5 * EnvironmentModel::AIR_DENSITY * dry_share * body.wind_area, node_air - w.cross(p),
                       g_air);

  const Vector3 steady(body.force.x(), body.force.y(), body.force.z() + lift.force - body.mass * sea.gravity());

  SeabedReaction ground;
  if (sea.hasSeabed() && !body.hull)
    ground = seabedReaction(body, sea, centre, node.velocity - R * w.cross(p), wt);

  RigidBodyResidual out;
  out.force = R * g - steady - ground.force;
  const Vector3 force_b = R.transpose() * out.force;
  out.moment = J.cwiseProduct(alpha) + w.cross(Jw) + u.cross(Mu) + spin_drag - thrust.torque -
               R.transpose() * lift.moment - p.cross(force_b);

  // Derivatives of g with respect to a, u and w at fixed others.
  const Matrix3 W = skew(w), P = skew(p), U = skew(u);
  const Matrix3 M = (body.mass * Vector3::Ones() + Ma).asDiagonal();
  const Matrix3 Md = Ma.asDiagonal();
  g_u += W * Md - Md * W;

  const Matrix3 g_w = Md * U - skew(Mu);
  // a and u change with the rotation: alpha (mass), w (damping), angle (stiffness).
  const Matrix3 a_r = wt.mass * P + wt.damping * (skew(w.cross(p)) + W * P) + wt.stiffness * skew(node_a);
  const Matrix3 u_r = wt.damping * P + wt.stiffness * skew(node_u);
  const Matrix3 g_r = M * a_r -
                      wt.stiffness * (Md + sea.density() * lift.volume * Matrix3::Identity()) * skew(water_a) +
                      g_u * u_r + wt.damping * g_w + g_air * (wt.damping * P + wt.stiffness * skew(node_air));
  const Matrix3 g_n = (wt.mass * M + wt.damping * (g_u + g_air)) * R.transpose();
  const Vector3 up = Vector3::UnitZ();
  const Matrix3 rise_r = R * P;  // d centre / d rotation in body axes

  out.force_n = R * g_n;
  out.force_n += ground.stiffness;
  out.force_n(2, 2) += wt.stiffness * lift.stiffness;
  out.force_r = R * (g_r - wt.stiffness * skew(g)) + ground.stiffness * rise_r;
  out.force_r.row(2) += wt.stiffness * (lift.stiffness * rise_r.row(2) - lift.force_turn.transpose() * R);
  const Matrix3 moment_u = U * Md - skew(Mu);
  m_w += W * Matrix3(J.asDiagonal()) - skew(Jw);

  out.moment_n = wt.damping * moment_u * R.transpose() - P * R.transpose() * out.force_n -
                 wt.stiffness * (R.transpose() * lift.moment_rise) * up.transpose();
  out.moment_r = wt.mass * Matrix3(J.asDiagonal()) + wt.damping * m_w + moment_u * u_r -
                 P * (R.transpose() * out.force_r + wt.stiffness * skew(force_b)) -
                 wt.stiffness * (R.transpose() * (lift.moment_turn * R + lift.moment_rise * rise_r.row(2)) +
                                 skew(R.transpose() * lift.moment));
  return out;
}

Vector3 steadyForce(const RigidBody& body, const EnvironmentModel& sea, const Vector3& attachment,
                    const Vector3& velocity)
{
  const AttachmentMotion node{attachment, velocity, Vector3::Zero()};
  return -rigidBodyResidual(body, sea, 0.0, node, AttitudeState(), Wrench(), TangentWeights{0.0, 0.0, 0.0}).force;
}

Vector3 bodyDrag(const RigidBody& body, const EnvironmentModel& sea, double t, const AttachmentMotion& node,
                 const AttitudeState& rotation)
{
  const Matrix3 R = rotation.orientation.toRotationMatrix();
  const Vector3 centre = node.position - R * body.attachment;
  const WaterKinematics water = sea.waterKinematics(centre, t);
  const Hydrostatics lift = hydrostaticsOf(body, sea, t, water.surface, centre, R);
  const Vector3 u = R.transpose() * (node.velocity - water.velocity) - rotation.velocity.cross(body.attachment);
  Matrix3 slope;
  return -(R * quadraticDrag(0.5 * sea.density() * lift.share * body.drag_area, u, slope));
}

Vector3 centreOfMass(const RigidBody& body, const Vector3& attachment, const AttitudeState& rotation)
{
  return attachment - rotation.orientation * body.attachment;
}

}  // namespace tether_monitor::core
