#pragma once

#include "tether_monitor/core/cable_model.h"
#include "tether_monitor/core/newton_options.h"

namespace tether_monitor::core
{
/// Size of a residual and what counts as zero for it.
struct ResidualSize
{
  double largest;    ///< over the free rows, couples divided by the element length [N]; NaN if one is not finite.
  double tolerance;  ///< [N]
  double norm;       ///< root of the sum of squares, couples divided by the element length [N].
};

/// Takes the position rows of both end nodes out of a residual (their value is the reaction) and measures the
/// rest. `residual` becomes the negative right-hand side for the free rows: held rows are set to zero.
ResidualSize holdEnds(const CableModel& model, const NodeField& q, const NewtonOptions& options,
                      NodeField& residual);

/// Makes the position rows of both end nodes identities.
void holdEnds(BlockTridiagonal& tangent);

}  // namespace tether_monitor::core
