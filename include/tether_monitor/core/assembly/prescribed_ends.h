#pragma once

#include "tether_monitor/core/assembly/cable_model.h"
#include "tether_monitor/core/base/newton_options.h"
#include "tether_monitor/core/cable/end_trajectory.h"

namespace tether_monitor::core
{
/// Which ends are held on given positions.
struct PrescribedEnds
{
  bool vessel = true;
  bool vehicle = true;
};

/// The ends that are held because no body of the model moves them.
PrescribedEnds prescribedEnds(const CableModel& model);

/// Puts the held end nodes of a trial state on their paths at its time.
void placePrescribedEnds(const CableModel& model, const BoundaryConditions& ends, CableState& trial);

/// Size of a residual and what counts as zero for it.
struct ResidualSize
{
  double largest;    ///< over the free rows, couples divided by the element length [N]; NaN if one is not finite.
  double tolerance;  ///< [N]
};

/// Takes the position rows of held end nodes out of a residual (their value is the reaction) and measures the
/// rest. `residual` becomes the negative right-hand side for the free rows: held rows are set to zero.
/// @param reaction  other forces that tell what is small [N].
ResidualSize imposePrescribedEnds(const CableModel& model, const NodeField& q, const NewtonOptions& options,
                                  const PrescribedEnds& held, NodeField& residual, double reaction = 0.0);

/// Makes the position rows of held end nodes identities.
void imposePrescribedEnds(const PrescribedEnds& held, BlockTridiagonal& tangent);

}  // namespace tether_monitor::core
