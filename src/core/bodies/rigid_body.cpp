#include "tether_monitor/core/bodies/rigid_body.h"

#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
std::vector<std::string> validate(const RigidBody& body, const std::string& prefix)
{
  BoundsCheck check(prefix);
  check.positive("mass", body.mass, "kg");
  check.notNegative("volume", body.volume, "m^3");
  const auto each = [&](const char* name, const Vector3& v, bool positive)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::string entry = std::string(name) + "[" + std::to_string(i) + "]";
      check.check(std::isfinite(v[i]) && (positive ? v[i] > 0.0 : v[i] >= 0.0), entry.c_str(), v[i],
                  positive ? "> 0" : ">= 0");
    }
  };
  each("inertia", body.inertia, true);
  each("drag_area", body.drag_area, false);
  each("added_mass", body.added_mass, false);
  each("added_inertia", body.added_inertia, false);
  each("rotational_drag", body.rotational_drag, false);
  each("wind_area", body.wind_area, false);
  check.finite("center_of_buoyancy (norm)", body.center_of_buoyancy.norm(), "m");
  check.finite("force (norm)", body.force.norm(), "N");
  check.finite("attachment (norm)", body.attachment.norm(), "m");
  if (body.hull)
  {
    each("hull.size", body.hull->size, true);
    check.finite("hull.keel (norm)", body.hull->keel.norm(), "m");
  }
  return check.problems();
}

}  // namespace tether_monitor::core
