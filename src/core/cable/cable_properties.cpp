#include "tether_monitor/core/cable/cable_properties.h"

#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::core
{
double CableProperties::displacedArea() const
{
  return M_PI * diameter * diameter / 4.0;
}

double CableProperties::stressArea() const
{
  return load_area.value_or(displacedArea());
}

std::vector<std::string> validate(const CableProperties& p)
{
  BoundsCheck check("tether.");
  check.positive("length", p.length, "m");
  check.positive("diameter", p.diameter, "m");
  check.positive("mass_per_length", p.mass_per_length, "kg/m");
  check.positive("axial_stiffness", p.axial_stiffness, "N");
  check.notNegative("bending_stiffness", p.bending_stiffness, "N m^2");
  check.notNegative("axial_damping", p.axial_damping, "s");
  check.notNegative("drag_normal", p.drag_normal, "[-]");
  check.notNegative("drag_tangential", p.drag_tangential, "[-]");
  check.notNegative("added_mass_normal", p.added_mass_normal, "[-]");
  check.notNegative("added_mass_tangential", p.added_mass_tangential, "[-]");
  check.within("hydrostatic_compression", p.hydrostatic_compression, 0.0, 1e-3, "1/m");
  check.within("permanent_elongation", p.permanent_elongation, 0.0, 0.5, "m/m");
  check.check(std::isfinite(p.working_load) && p.working_load > 0.0 && !(p.working_load > p.breaking_load),
              "working_load", p.working_load, "> 0 N and <= breaking_load");
  check.positive("breaking_load", p.breaking_load, "N");
  if (p.contact_diameter)
    check.positive("contact_diameter", *p.contact_diameter, "m");
  if (p.load_area)
    check.positive("load_area", *p.load_area, "m^2");
  if (p.min_bend_radius)
    check.positive("min_bend_radius", *p.min_bend_radius, "m");
  return check.problems();
}

}  // namespace tether_monitor::core
