#include "tether_monitor/core/assembly/lumped_attachment.h"

#include <cmath>

#include "tether_monitor/core/element/submergence.h"

namespace tether_monitor::core
{
Vector3 lumpedAttachmentResidual(const LumpedAttachment& load, const EnvironmentModel& sea, double time,
                                 const Vector3& r, const Vector3& v, const Vector3& a,
                                 const TangentWeights& weights, Matrix3* tangent)
{
  const WaterKinematics water = sea.waterKinematics(r, time);
  const Submergence wet = submergence(r.z() - water.surface, std::cbrt(load.volume) + 1e-3);
  const double displaced = sea.density() * load.volume;
  const double drag = 0.5 * sea.density() * load.drag_area * wet.share;
  const Vector3 u = v - water.velocity;
  const double speed = u.norm();
  Vector3 force = load.mass * a + drag * speed * u - displaced * wet.share * water.acceleration;  // (M20)
  force.z() += sea.gravity() * (load.mass - displaced * wet.share);
  if (tangent)
  {
    *tangent = (weights.mass * load.mass + weights.damping * drag * speed) * Matrix3::Identity();
    if (speed > 0.0)
      *tangent += weights.damping * drag / speed * u * u.transpose();
    (*tangent)(2, 2) += weights.stiffness * sea.gravity() * displaced * wet.slope;
  }
  return force;
}

}  // namespace tether_monitor::core
