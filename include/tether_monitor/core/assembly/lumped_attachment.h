#pragma once

#include "tether_monitor/core/base/tangent_weights.h"
#include "tether_monitor/core/cable/cable_state.h"
#include "tether_monitor/core/environment/environment_model.h"
#include "tether_monitor/core/linalg/block_tridiagonal.h"

namespace tether_monitor::core
{
/// A weight, float or buoy at a node, ready for the stepping path.
struct LumpedAttachment
{
  int node = 0;
  double mass = 0.0;       ///< [kg]
  double volume = 0.0;     ///< [m^3]
  double drag_area = 0.0;  ///< [m^2]
};

/// Motion of a point: position [m], velocity [m/s], acceleration [m/s^2]; and of the water there, beyond that of
/// the environment [m/s].
struct PointMotion
{
  Vector3 r = Vector3::Zero(), v = Vector3::Zero(), a = Vector3::Zero(), current = Vector3::Zero();
};

/// Force that an attachment needs from outside [N].
///
/// Model: m a + (m - rho V phi) g up + 1/2 rho CdA phi |u| u - rho V phi a_water, (M20) of doc/model.md.
Vector3 lumpedAttachmentResidual(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                                 double time, const PointMotion& motion);

/// Its derivative, weighted.
Matrix3 lumpedAttachmentTangent(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                                double time, const PointMotion& motion, const TangentWeights& weights);

/// Adds it to the residual of its node.
void addLumpedAttachment(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                         const CableState& state, NodeField& residual);
/// The same with the iteration matrix.
void addLumpedAttachment(const LumpedAttachment& attachment, const EnvironmentModel& environment,
                         const CableState& state, const TangentWeights& weights, NodeField& residual,
                         BlockTridiagonal& tangent);

}  // namespace tether_monitor::core
