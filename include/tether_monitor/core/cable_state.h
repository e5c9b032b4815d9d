#pragma once

#include "tether_monitor/core/types.h"

namespace tether_monitor::core
{
/// Everything that the stepping of a tether carries from one step to the next. Plain data: copy it to save it.
struct CableState
{
  double time = 0.0;  ///< [s] of the input clock.
  double step = 0.0;  ///< size of the last accepted step [s]; 0: take the largest allowed.
  NodeField q;        ///< coordinates.
  NodeField v;        ///< first time derivative.
  NodeField a;        ///< second time derivative; satisfies the equations of motion at `time`.
  NodeField aux;      ///< algorithmic acceleration of the generalised-alpha scheme, (M12).

  CableState() = default;
  /// Coordinates `shape` at time `t`, in uniform motion with velocity V [m/s] and no acceleration.
  CableState(double t, const NodeField& shape, const Vector3& V);

  /// True if every number is finite.
  bool allFinite() const;
};

}  // namespace tether_monitor::core
