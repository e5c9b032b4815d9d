#include "tether_monitor/monitor/config/config_fingerprint.h"

#include "tether_monitor/core/base/binary_archive.h"

namespace tether_monitor::monitor
{
namespace
{
using core::BinaryWriter;

void add(const core::CableProperties& p, BinaryWriter& to)
{
  to(p.length, p.diameter, p.mass_per_length, p.axial_stiffness, p.bending_stiffness, p.axial_damping,
     p.drag_normal, p.drag_tangential, p.added_mass_normal, p.added_mass_tangential, p.contact_diameter,
     p.hydrostatic_compression, p.permanent_elongation, p.working_load, p.breaking_load, p.load_area,
     p.min_bend_radius);
  to(p.axial_stiffening.count);
  for (int k = 0; k < p.axial_stiffening.count; ++k)
    to(p.axial_stiffening.strain[k], p.axial_stiffening.change[k]);
}

void add(const core::CableLayout& layout, BinaryWriter& to)
{
  for (const core::CableSection& section : layout.sections)
  {
    to(section.from, section.to);
    add(section.properties, to);
  }
  for (const core::Attachment& a : layout.attachments)
    to(a.s, a.mass, a.volume, a.drag_area);
}

void add(const core::SeaState& waves, BinaryWriter& to)
{
  to(waves.stretching, waves.spectrum.has_value());
  for (const core::WaveProperties& wave : waves.components)
    to(wave.amplitude, wave.length, wave.direction, wave.phase);
  if (const auto& s = waves.spectrum)
    to(s->significant_height, s->peak_period, s->gamma, s->direction, s->spreading, s->seed, s->components);
}

void add(const core::Environment& sea, BinaryWriter& to)
{
  to(sea.water_density, sea.gravity, sea.wind);
  add(sea.waves, to);
  const bool has_seabed = sea.seabed.has_value();
  to(has_seabed);
  if (has_seabed)
    to(sea.seabed->depth, sea.seabed->slope, sea.seabed->normal_stiffness, sea.seabed->damping,
       sea.seabed->friction);
}

void add(const core::RigidBody& body, BinaryWriter& to)
{
  to(body.mass, body.volume, body.inertia, body.drag_area, body.added_mass, body.added_inertia,
     body.rotational_drag, body.center_of_buoyancy, body.force, body.wind_area);
}

void add(const NavigationConfig& n, BinaryWriter& to)
{
  to(n.position_stddev, n.velocity_stddev, n.latency, n.drag_stddev, n.degraded_stddev, n.invalid_stddev);
}

void add(const UncertaintyConfig& u, BinaryWriter& to)
{
  to(u.drag_normal, u.drag_tangential, u.mass_per_length, u.length, u.axial_stiffness, u.current, u.tension_stddev,
     u.tension_bias, u.direction_stddev, u.fouling_memory, u.members);
}
}  // namespace

std::uint64_t fingerprint(const Config& config)
{
  const Config& c = config;
  BinaryWriter to;
  add(c.tether, to);
  add(c.layout, to);
  add(c.environment, to);
  if (c.vehicle_mode != VehicleMode::TRACKED)
    add(c.vehicle_body, to);
  if (c.vehicle_mode == VehicleMode::OBSERVED)
  {
    add(c.navigation, to);
    add(c.uncertainty, to);
    to(unknownForceStddev(c), c.vessel.position_stddev, c.vessel.velocity_stddev, c.vessel.least_stddev,
       c.vehicle.least_stddev, c.invalid_timeout);
  }
  else
  {
    to(c.vehicle.position_stddev);
  }
  to(c.vehicle_mode, c.drag_amplification, c.vessel.attachment, c.vehicle.attachment, c.vessel.clamped,
     c.vehicle.clamped, c.accuracy);
  if (!c.accuracy)
    to(c.elements);
  to(c.solver.step, c.solver.spectral_radius, c.solver.max_halvings, c.solver.max_iterations, c.solver.scheme,
     c.solver.corrections, c.solver.courant, c.solver.newton.relative_tolerance, c.solver.newton.max_iterations);
  if (c.inputs.datum)
    to(c.inputs.datum->latitude, c.inputs.datum->longitude, c.inputs.datum->yaw, c.inputs.datum->altitude);
  for (const auto& [name, alarm] : config.alarms)
    to(name, alarm);
  return core::checksum(to.bytes());
}

}  // namespace tether_monitor::monitor
