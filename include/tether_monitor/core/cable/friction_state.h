#pragma once

#include <vector>

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// How friction acts.
enum class FrictionMode
{
  COULOMB,  ///< springs that slip at Coulomb's limit.
  SLIP,     ///< steady motion: against the velocity, at the limit.
  STICK     ///< springs that never slip, while a steady state is looked for.
};

/**
 * The anchor points of friction: for every integration point the place on a surface to which its friction spring
 * is tied, (M23). Empty while nothing can be touched.
 */
struct FrictionState
{
  double time = 0.0;  ///< [s] of these places.
  double step = 0.0;  ///< [s] of the step that is, or was, made: a contact is damped at least as it can resolve.
  FrictionMode friction = FrictionMode::COULOMB;
  std::vector<Vector3> seabed;             ///< [m]
  std::vector<Vector3> obstacle;           ///< [m] on the obstacle touched deepest.
  std::vector<Vector3> obstacle_position;  ///< centre of every obstacle [m].

  template <class Archive>
  void serialize(Archive& a)
  {
    a(time, step, friction, seabed, obstacle, obstacle_position);
  }
};

}  // namespace tether_monitor::core
