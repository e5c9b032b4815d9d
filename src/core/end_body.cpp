#include "tether_monitor/core/end_body.h"

#include <cmath>

#include "tether_monitor/core/bounds.h"
#include "tether_monitor/core/buoyancy.h"

namespace tether_monitor::core
{
std::vector<std::string> problems(const EndBody& body)
{
  BoundsCheck check("vehicle.");
  check.positive("mass", body.mass, "kg");
  check.notNegative("volume", body.volume, "m^3");
  const auto each = [&](const char* name, const Vector3& v, bool positive)
  {
    for (int i = 0; i < 3; ++i)
    {
      const std::string entry = std::string(name) + "[" + std::to_string(i) + "]";
      check.require(std::isfinite(v[i]) && (positive ? v[i] > 0.0 : v[i] >= 0.0), entry.c_str(), v[i],
                    positive ? "> 0" : ">= 0");
    }
  };
  each("inertia", body.inertia, true);
  each("drag_area", body.drag_area, false);
  check.finite("force (norm)", body.force.norm(), "N");
  return check.problems();
}

Vector3 steadyForce(const EndBody& body, const Environment& sea, const Vector3& position, const Vector3& velocity)
{
  const double share = submersion(position.z(), std::cbrt(body.volume) + 1e-6).share;
  const Vector3 u = velocity - sea.waterVelocity(position);
  Vector3 force = body.force;
  force.z() += sea.gravity * (sea.water_density * body.volume * share - body.mass);
  force -= 0.5 * sea.water_density * share * u.norm() * body.drag_area.cwiseProduct(u);  // (M19)
  return force;
}

}  // namespace tether_monitor::core
