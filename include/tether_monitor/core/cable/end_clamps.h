#pragma once

#include "tether_monitor/core/base/types.h"

namespace tether_monitor::core
{
/// How the ends are clamped: unit directions along growing s in which they are held, world axes; zero: hinged.
struct EndClamps
{
  Vector3 vessel = Vector3::Zero();
  Vector3 vehicle = Vector3::Zero();  ///< for a held end.

  template <class Archive>
  void serialize(Archive& a)
  {
    a(vessel, vehicle);
  }
};

}  // namespace tether_monitor::core
