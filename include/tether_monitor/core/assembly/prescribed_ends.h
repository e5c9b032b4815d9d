#pragma once

#include "tether_monitor/core/assembly/deployed_cable.h"
#include "tether_monitor/core/base/newton_options.h"
#include "tether_monitor/core/cable/boundary_conditions.h"

namespace tether_monitor::core
{
/// Which ends are held on given positions (Dirichlet conditions).
struct PrescribedEnds
{
  bool vessel = true;
  bool vehicle = true;
};

/// The ends that are held because no body of the model moves them.
PrescribedEnds prescribedEnds(const EndBodies& bodies);

/// Puts the held end nodes of a trial state on their trajectories at its time.
void placePrescribedEnds(const EndBodies& bodies, const BoundaryConditions& ends, CableState& trial);

/// Size of a residual and what counts as zero for it.
struct ResidualSize
{
  double largest;    ///< over the free rows, couples divided by the element length [N]; NaN if one is not finite.
  double tolerance;  ///< [N]
};

/// Accepts the position rows of held end nodes out of a residual (their value is the reaction) and measures the
/// rest. `residual` becomes the negative right-hand side for the free rows: held rows are set to zero.
/// @param reaction  other forces that tell what is small [N].
ResidualSize imposePrescribedEnds(const DeployedCable& cable, const NodeField& q, const NewtonOptions& options,
                                  const PrescribedEnds& held, NodeField& residual, double reaction = 0.0);

/// Makes the position rows of held end nodes identities.
void imposePrescribedEnds(const PrescribedEnds& held, BlockTridiagonal& tangent);

}  // namespace tether_monitor::core
