#include "tether_monitor/monitor/config/config.h"

#include <cmath>

#include "tether_monitor/core/base/bounds_check.h"

namespace tether_monitor::monitor
{
namespace
{
constexpr double DEFAULT_ACCELERATION = 0.16;  // of unknown forces, over the mass [m/s^2]

void add(const std::vector<std::string>& more, std::vector<std::string>& all)
{
  all.insert(all.end(), more.begin(), more.end());
}

std::vector<std::string> validate(const NavigationConfig& n)
{
  core::BoundsCheck check("vehicle.");
  check.positive("position_stddev", n.position_stddev, "m");
  check.positive("velocity_stddev", n.velocity_stddev, "m/s");
  check.within("latency", n.latency, 0.0, 30.0, "s");
  if (n.force_stddev)
    check.positive("force_stddev", *n.force_stddev, "N");
  check.positive("drag_stddev", n.drag_stddev, "[-]");
  core::BoundsCheck band("monitor.");
  band.positive("degraded_stddev", n.degraded_stddev, "[-]");
  band.check(std::isfinite(n.invalid_stddev) && n.invalid_stddev >= n.degraded_stddev, "invalid_stddev",
             n.invalid_stddev, ">= degraded_stddev");
  std::vector<std::string> all = check.problems();
  add(band.problems(), all);
  return all;
}

std::vector<std::string> validate(const UncertaintyConfig& u)
{
  core::BoundsCheck tether("tether.uncertainty.");
  const auto relative = [&](core::BoundsCheck& check, const char* name, double value)
  { check.within(name, value, 0.0, 1.0, "[-]"); };
  relative(tether, "drag_normal", u.drag_normal);
  relative(tether, "drag_tangential", u.drag_tangential);
  tether.within("mass_per_length", u.mass_per_length, 0.0, 0.2, "[-]");
  tether.within("length", u.length, 0.0, 0.1, "[-]");
  relative(tether, "axial_stiffness", u.axial_stiffness);
  core::BoundsCheck others;
  others.within("environment.current_stddev", u.current, 0.0, 5.0, "m/s");
  others.within("tension_sensor.stddev", u.tension_stddev, 1e-6, 1.0, "[-]");
  others.within("tension_sensor.bias_stddev", u.tension_bias, 0.0, 1.0, "[-]");
  others.within("direction_sensor.stddev", u.direction_stddev, 1e-4, 1.0, "rad");
  others.within("solver.members", u.members, 64, 512, "tethers");
  std::vector<std::string> all = tether.problems();
  add(others.problems(), all);
  return all;
}

void validateBody(const std::string& prefix, const BodyConfig& body, std::vector<std::string>& all)
{
  core::BoundsCheck check(prefix);
  check.positive("least_stddev", body.least_stddev, "m");
  if (body.position_stddev)
    check.positive("position_stddev", *body.position_stddev, "m");
  if (body.velocity_stddev)
    check.positive("velocity_stddev", *body.velocity_stddev, "m/s");
  if (body.height)
    check.within("height", *body.height, -100.0, 100.0, "m");
  add(check.problems(), all);
}

// Bending stiffness at the vessel end (s = 0) or the vehicle end [N m^2].
double endBendingStiffness(const Config& c, double s)
{
  for (const core::CableSection& section : c.layout.sections)
    if (section.from <= s && s <= section.to)
      return section.properties.bending_stiffness;
  return c.tether.bending_stiffness;
}

void validateClamp(const Config& c, const std::string& name, const BodyConfig& body, double s,
                   std::vector<std::string>& all)
{
  if (!body.clamped)
    return;
  core::BoundsCheck check(name + ".");
  const double norm = body.clamped->norm();
  check.check(std::isfinite(norm) && norm > 0.0, "clamped (norm)", norm, "> 0: a direction");
  check.check(endBendingStiffness(c, s) > 0.0, "clamped (bending_stiffness of the tether there)",
              endBendingStiffness(c, s), "> 0 N m^2: a tether without it leaves a clamp as it leaves a hinge");
  check.check(c.solver.scheme != core::Scheme::ABARBANEL_ZWAS, "clamped (solver.integrator abarbanel_zwas)", norm,
              "absent: the explicit scheme has no clamps");
  if (name == "vehicle")
    check.check(c.vehicle_mode == VehicleMode::TRACKED, "clamped (vehicle.mode)", norm,
                "absent unless vehicle.mode is tracked: only a held end can be clamped");
  add(check.problems(), all);
}
}  // namespace

double unknownForceStddev(const Config& c)
{
  return c.navigation.force_stddev.value_or(DEFAULT_ACCELERATION * c.vehicle_body.mass);
}

std::vector<std::string> validate(const Config& c)
{
  std::vector<std::string> all = core::validate(c.environment);
  add(core::validate(c.tether), all);
  add(core::validate(c.layout, c.tether.length), all);
  add(core::validateElementCount(c.elements, c.tether.length, c.layout), all);
  add(core::validate(c.solver), all);
  if (c.vehicle_mode != VehicleMode::TRACKED)
    add(core::validate(c.vehicle_body), all);
  if (c.vehicle_mode == VehicleMode::OBSERVED)
    add(validate(c.navigation), all);
  add(validate(c.uncertainty), all);
  validateBody("vessel.", c.vessel, all);
  validateBody("vehicle.", c.vehicle, all);
  validateClamp(c, "vessel", c.vessel, 0.0, all);
  validateClamp(c, "vehicle", c.vehicle, c.tether.length, all);

  if (c.winch)
    add(core::validate(*c.winch, c.tether.diameter, c.tether.length, c.tether.min_bend_radius.value_or(0.0)), all);
  core::BoundsCheck strumming("tether.");
  strumming.within("drag_amplification", c.drag_amplification, 1.0, 10.0, "[-]");
  if (c.accuracy)
    strumming.within("accuracy", *c.accuracy, 1e-5, 0.1, "[-]");
  add(strumming.problems(), all);

  core::BoundsCheck check("monitor.");
  check.within("rate", c.rate, 0.1, 1000.0, "Hz");
  check.positive("pose_timeout", c.pose_timeout, "s");
  check.within("forecast.horizon", c.forecast.horizon, 1.0, 300.0, "s");
  check.within("forecast.rate", c.forecast.rate, 0.0, 5.0, "Hz");
  check.within("forecast.members", c.forecast.members, 8, 1000, "[-]");
  check.within("realtime.priority", c.runtime.priority, 0, 99, "[-]");
  check.check(std::isfinite(c.invalid_timeout) && c.invalid_timeout >= c.pose_timeout, "invalid_timeout",
              c.invalid_timeout, ">= pose_timeout, in s");
  add(check.problems(), all);

  add(validate(c.inputs), all);
  core::BoundsCheck levers;
  levers.finite("vessel.attachment (norm)", c.vessel.attachment.norm(), "m");
  levers.finite("vehicle.attachment (norm)", c.vehicle.attachment.norm(), "m");
  if (c.max_thrust)
    levers.positive("vehicle.max_thrust", *c.max_thrust, "N");
  levers.check(!c.world_frame.empty(), "world_frame (number of characters)", 0, "a frame's name");
  add(levers.problems(), all);
  return all;
}

}  // namespace tether_monitor::monitor
