#include "tether_monitor/core/assembly/lumped_attachment.h"

#include <cmath>

#include "tether_monitor/core/element/submergence.h"

namespace tether_monitor::core
{
namespace
{
constexpr double LEAST_EXTENT = 1e-3;  // of what pierces the surface [m]

// The flow past an attachment.
struct Flow
{
  WaterKinematics water;
  Submergence<double> submergence;
  Vector3 u;         // relative to the water
  double displaced;  // mass of the water that it displaces when submerged [kg]
  double drag;       // 1/2 rho CdA phi
};

Flow flowPast(const LumpedAttachment& attachment, const EnvironmentModel& environment, double time,
              const PointMotion& motion)
{
  Flow flow;
  flow.water = environment.waterKinematics(motion.r, time);
  flow.submergence = submergence(motion.r.z() - flow.water.surface, std::cbrt(attachment.volume) + LEAST_EXTENT);
  flow.u = motion.v - flow.water.velocity - motion.current;
  flow.displaced = environment.density() * attachment.volume;
  flow.drag = 0.5 * environment.density() * attachment.drag_area * flow.submergence.fraction;
  return flow;
}

PointMotion motionOf(const LumpedAttachment& attachment, const CableState& state)
{
  return {state.q[attachment.node].head<3>(), state.v[attachment.node].head<3>(),
          state.a[attachment.node].head<3>(), state.deployment.variation.currentAt(state.q[attachment.node].z())};
}
}  // namespace

Vector3 lumpedAttachmentResidual(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                                 double time, const PointMotion& motion)
{
  const Flow flow = flowPast(attachment, environment, time, motion);
  const double wet = flow.displaced * flow.submergence.fraction;
  Vector3 force = attachment.mass * motion.a + flow.drag * flow.u.norm() * flow.u - wet * flow.water.acceleration;
  force.z() += environment.gravity() * (attachment.mass - wet);  // (M20)
  return force;
}

Matrix3 lumpedAttachmentTangent(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                                double time, const PointMotion& motion, const TangentWeights& weights)
{
  const Flow flow = flowPast(attachment, environment, time, motion);
  const double speed = flow.u.norm();
  Matrix3 tangent = (weights.mass * attachment.mass + weights.damping * flow.drag * speed) * Matrix3::Identity();
  if (speed > 0.0)
    tangent += weights.damping * flow.drag / speed * flow.u * flow.u.transpose();
  tangent(2, 2) += weights.stiffness * environment.gravity() * flow.displaced * flow.submergence.slope;
  return tangent;
}

void addLumpedAttachment(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                         const CableState& state, NodeField& residual)
{
  residual[attachment.node].head<3>() +=
      lumpedAttachmentResidual(attachment, environment, state.time, motionOf(attachment, state));
}

void addLumpedAttachment(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                         const CableState& state, const TangentWeights& weights, NodeField& residual,
                         BlockTridiagonal& tangent)
{
  addLumpedAttachment(attachment, environment, state, residual);
  tangent.diagonal(attachment.node).topLeftCorner<3, 3>() +=
      lumpedAttachmentTangent(attachment, environment, state.time, motionOf(attachment, state), weights);
}

}  // namespace tether_monitor::core
