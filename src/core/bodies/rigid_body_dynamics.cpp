#include "tether_monitor/core/bodies/rigid_body_dynamics.h"

#include <cmath>

#include "tether_monitor/core/base/so3.h"
#include "tether_monitor/core/bodies/hydrostatics.h"
#include "tether_monitor/core/bodies/seabed_landing.h"

namespace tether_monitor::core
{
namespace
{
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

// How the body moves, through the water and through the air, in body axes.
struct Kinematics
{
  Matrix3 R;                                  // body to world
  Vector3 centre;                             // of mass, model coordinates
  WaterKinematics water;                      // there, world axes
  Vector3 node_a, water_a, node_u, node_air;  // acceleration, and velocity against water and air, of the node
  Vector3 a, u;                               // of the centre of mass: acceleration, velocity against the water
};

Kinematics kinematics(const RigidBody& body, const EnvironmentModel& environment, const RigidBodyMotion& motion)
{
  Kinematics k;
  const Vector3& p = body.attachment;
  const Vector3& w = motion.attitude.velocity;
  k.R = motion.attitude.orientation.toRotationMatrix();
  k.centre = motion.position - k.R * p;
  k.water = environment.waterKinematics(k.centre, motion.time);
  k.water.velocity += motion.variation.currentAt(k.centre.z());
  k.node_a = k.R.transpose() * motion.acceleration;
  k.water_a = k.R.transpose() * k.water.acceleration;
  k.node_u = k.R.transpose() * (motion.velocity - k.water.velocity);
  k.node_air = k.R.transpose() * (motion.velocity - environment.wind());
  k.a = k.node_a - (motion.attitude.acceleration.cross(p) + w.cross(w.cross(p)));
  k.u = k.node_u - w.cross(p);
  return k;
}

// Inertia and drag of the body where it is, with the derivatives of the drag.
struct Hydrodynamics
{
  Vector3 added_mass, inertia;  // with the added inertia
  Vector3 drag, spin_drag, wind_drag;
  Matrix3 drag_u, spin_drag_w, wind_drag_u;
};

Hydrodynamics hydrodynamics(const RigidBody& body, const EnvironmentModel& environment, const Kinematics& k,
                            const Hydrostatics& lift, const RigidBodyMotion& motion)
{
  const Vector3& w = motion.attitude.velocity;
  Hydrodynamics h;
  const double wet = lift.submerged_fraction;
  h.added_mass = wet * body.added_mass;
  h.inertia = body.inertia + wet * body.added_inertia;
  h.drag = quadraticDrag(0.5 * environment.density() * wet * motion.variation.vehicle_drag * body.drag_area, k.u,
                         h.drag_u);
  h.spin_drag = quadraticDrag(wet * body.rotational_drag, w, h.spin_drag_w);
  h.wind_drag = Vector3::Zero();
  h.wind_drag_u = Matrix3::Zero();
  if (body.wind_area.squaredNorm() > 0.0)
  {
    const double dry = body.hull ? 1.0 : 1.0 - wet;
    h.wind_drag = quadraticDrag(0.5 * EnvironmentModel::AIR_DENSITY * dry * body.wind_area,
                                k.node_air - w.cross(body.attachment), h.wind_drag_u);
  }
  return h;
}

// Force that the body needs, body axes: inertia, added inertia (Kirchhoff), drag, less thrust and the waves' push.
Vector3 neededForce(const RigidBody& body, const EnvironmentModel& environment, const Kinematics& k,
                    const Hydrodynamics& h, const Hydrostatics& lift, const Vector3& w, const Wrench& thrust)
{
  return body.mass * k.a + h.added_mass.cwiseProduct(k.a - k.water_a - w.cross(k.u)) +
         w.cross(h.added_mass.cwiseProduct(k.u)) + h.drag - thrust.force -
         environment.density() * lift.submerged_volume * k.water_a + h.wind_drag;
}
}  // namespace

RigidBodyMotion rigidBodyMotion(const CableState& state, std::size_t node, const AttitudeState& attitude)
{
  return {state.time, state.q[node].head<3>(),   state.v[node].head<3>(), state.a[node].head<3>(),
          attitude,   state.deployment.variation};
}

RigidBodyResidual rigidBodyResidual(const RigidBody& body, const EnvironmentModel& environment,
                                    const RigidBodyMotion& motion, const Wrench& thrust, const TangentWeights& wt)
{
  const Vector3& p = body.attachment;
  const Vector3& w = motion.attitude.velocity;
  const Kinematics k = kinematics(body, environment, motion);
  const Matrix3& R = k.R;
  const Hydrostatics lift = hydrostatics(body, environment, motion.time, k.water, k.centre, R);
  Hydrodynamics h = hydrodynamics(body, environment, k, lift, motion);
  const SeabedReaction ground = seabedReaction(body, environment, k.centre, motion.velocity - R * w.cross(p), wt);
  const Vector3 Mu = h.added_mass.cwiseProduct(k.u), Jw = h.inertia.cwiseProduct(w);
  const Vector3 g = neededForce(body, environment, k, h, lift, w, thrust);
  const Vector3 steady(body.force.x(), body.force.y(),
                       body.force.z() + lift.force - body.mass * environment.gravity());

  RigidBodyResidual out;
  out.force = R * g - steady - ground.force;
  const Vector3 force_b = R.transpose() * out.force;
  out.moment = h.inertia.cwiseProduct(motion.attitude.acceleration) + w.cross(Jw) + k.u.cross(Mu) + h.spin_drag -
               thrust.torque - R.transpose() * lift.moment - p.cross(force_b);

  // Derivatives of g with respect to a, u and w at fixed others.
  const Matrix3 W = skew(w), P = skew(p), U = skew(k.u);
  const Matrix3 M = (body.mass * Vector3::Ones() + h.added_mass).asDiagonal();
  const Matrix3 Md = h.added_mass.asDiagonal(), J = h.inertia.asDiagonal();
  h.drag_u += W * Md - Md * W;
  const Matrix3 g_w = Md * U - skew(Mu);
  // a and u change with the rotation: angular acceleration (mass), velocity (damping), angle (stiffness).
  const Matrix3 a_r = wt.mass * P + wt.damping * (skew(w.cross(p)) + W * P) + wt.stiffness * skew(k.node_a);
  const Matrix3 u_r = wt.damping * P + wt.stiffness * skew(k.node_u);
  const double displaced = environment.density() * lift.submerged_volume;
  const Matrix3 g_r = M * a_r - wt.stiffness * (Md + displaced * Matrix3::Identity()) * skew(k.water_a) +
                      h.drag_u * u_r + wt.damping * g_w +
                      h.wind_drag_u * (wt.damping * P + wt.stiffness * skew(k.node_air));
  const Matrix3 g_n = (wt.mass * M + wt.damping * (h.drag_u + h.wind_drag_u)) * R.transpose();
  const Matrix3 heave_r = R * P;  // d centre / d rotation in body axes

  out.force_n = R * g_n + ground.stiffness;
  out.force_n(2, 2) += wt.stiffness * lift.heave_stiffness;
  out.force_r = R * (g_r - wt.stiffness * skew(g)) + ground.stiffness * heave_r;
  out.force_r.row(2) +=
      wt.stiffness * (lift.heave_stiffness * heave_r.row(2) - lift.force_rotation.transpose() * R);
  const Matrix3 moment_u = U * Md - skew(Mu);
  h.spin_drag_w += W * J - skew(Jw);
  out.moment_n = wt.damping * moment_u * R.transpose() - P * R.transpose() * out.force_n -
                 wt.stiffness * (R.transpose() * lift.moment_heave) * Vector3::UnitZ().transpose();
  out.moment_r = wt.mass * J + wt.damping * h.spin_drag_w + moment_u * u_r -
                 P * (R.transpose() * out.force_r + wt.stiffness * skew(force_b)) -
                 wt.stiffness * (R.transpose() * (lift.moment_rotation * R + lift.moment_heave * heave_r.row(2)) +
                                 skew(R.transpose() * lift.moment));
  return out;
}

Vector3 steadyForce(const RigidBody& body, const EnvironmentModel& environment, const Vector3& attachment,
                    const Vector3& velocity)
{
  const RigidBodyMotion motion{0.0, attachment, velocity, Vector3::Zero(), AttitudeState()};
  return -rigidBodyResidual(body, environment, motion, Wrench(), TangentWeights{0.0, 0.0, 0.0}).force;
}

Vector3 bodyDrag(const RigidBody& body, const EnvironmentModel& environment, const RigidBodyMotion& motion)
{
  const Kinematics k = kinematics(body, environment, motion);
  const Hydrostatics lift = hydrostatics(body, environment, motion.time, k.water, k.centre, k.R);
  return -(k.R * hydrodynamics(body, environment, k, lift, motion).drag);
}

Vector3 centreOfMass(const RigidBody& body, const Vector3& attachment, const AttitudeState& attitude)
{
  return attachment - attitude.orientation * body.attachment;
}

}  // namespace tether_monitor::core
