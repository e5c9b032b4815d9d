#include "tether_monitor/params/load_config.h"

#include <algorithm>

#include "tether_monitor/params/reader.h"

namespace tether_monitor::params
{
namespace
{
core::CurrentProfile loadCurrent(Reader& in)
{
  std::vector<core::CurrentProfile::Sample> samples;
  for (Reader& entry : in.children("current"))
  {
    samples.push_back({entry.number("depth"), entry.vector("velocity")});
    entry.finish();
  }
  std::vector<std::string> faults = core::problems(samples);
  for (std::string& fault : faults)
    fault = "environment." + fault;
  in.report(faults);
  return faults.empty() ? core::CurrentProfile(samples) : core::CurrentProfile();
}

core::Environment loadEnvironment(Reader in)
{
  core::Environment sea;
  sea.water_density = in.number("water_density", sea.water_density);
  sea.gravity = in.number("gravity", sea.gravity);
  sea.current = loadCurrent(in);
  for (const char* key : {"wind", "obstacles", "seabed"})
    in.notBuiltYet(key);
  if (in.has("waves"))
  {
    Reader waves = in.child("waves");
    waves.notBuiltYet("amplitude");
    for (const char* key : {"length", "direction", "phase"})
      waves.number(key, 0.0);
    waves.finish();
  }
  in.finish();
  return sea;
}

// The properties from `diameter` on: of the tether, or of a section that differs from it where it says so.
void loadProperties(Reader& in, const core::CableProperties* base, core::CableProperties& p)
{
  const auto required = [&](const char* key, double core::CableProperties::*member)
  { p.*member = base ? in.number(key, base->*member) : in.number(key); };
  required("diameter", &core::CableProperties::diameter);
  required("mass_per_length", &core::CableProperties::mass_per_length);
  required("axial_stiffness", &core::CableProperties::axial_stiffness);
  p.bending_stiffness = in.number("bending_stiffness", p.bending_stiffness);
  p.axial_damping = in.number("axial_damping", p.axial_damping);
  required("drag_normal", &core::CableProperties::drag_normal);
  required("drag_tangential", &core::CableProperties::drag_tangential);
  p.added_mass_normal = in.number("added_mass_normal", p.added_mass_normal);
  if (in.has("load_area"))
    p.load_area = in.optionalNumber("load_area");
  required("working_load", &core::CableProperties::working_load);
  required("breaking_load", &core::CableProperties::breaking_load);
  for (const char* key : {"hydrostatic_compression", "permanent_elongation"})
    in.notBuiltYet(key);
}

core::CableFittings loadFittings(Reader& in, const core::CableProperties& tether)
{
  core::CableFittings fittings;
  for (Reader& entry : in.children("sections"))
  {
    core::CableSection section;
    section.from = entry.number("from");
    section.to = entry.number("to");
    section.properties = tether;
    loadProperties(entry, &tether, section.properties);
    entry.finish();
    fittings.sections.push_back(section);
  }
  for (Reader& entry : in.children("attachments"))
  {
    core::Attachment attachment;
    attachment.name = entry.text("name", "");
    attachment.s = entry.number("s");
    attachment.mass = entry.number("mass");
    attachment.volume = entry.number("volume");
    attachment.drag_area = entry.number("drag_area", 0.0);
    entry.finish();
    fittings.attachments.push_back(attachment);
  }
  return fittings;
}

void loadTether(Reader in, monitor::Config& config)
{
  core::CableProperties& p = config.tether;
  p.length = in.number("length");
  config.elements = in.integer("elements");
  loadProperties(in, nullptr, p);
  p.min_bend_radius = in.optionalNumber("min_bend_radius");
  config.fittings = loadFittings(in, p);
  in.finish();
}

monitor::BodyConfig loadBody(Reader& in)
{
  monitor::BodyConfig body;
  body.attachment = in.vector("attachment", body.attachment);
  body.frame = in.text("frame", body.frame);
  return body;
}

monitor::BodyConfig loadVessel(Reader in)
{
  const monitor::BodyConfig body = loadBody(in);
  in.finish();
  return body;
}

void loadVehicle(Reader in, monitor::Config& config)
{
  config.vehicle = loadBody(in);
  const std::string mode = in.text("mode", "tracked");
  if (mode == "free")
  {
    config.vehicle_mode = monitor::VehicleMode::FREE;
    core::RigidBody& body = config.vehicle_body;
    body.mass = in.number("mass");
    body.volume = in.number("volume");
    body.inertia = in.vector("inertia");
    body.drag_area = in.vector("drag_area");
    body.force = in.vector("force", body.force);
  }
  else if (mode != "tracked")
  {
    in.report({"vehicle.mode = '" + mode + "' (must be tracked or free)"});
  }
  in.finish();
}

core::StepperOptions loadSolver(Reader in)
{
  core::StepperOptions options;
  const std::string integrator = in.text("integrator", "generalized_alpha");
  if (integrator != "generalized_alpha")
    in.report({"solver.integrator = '" + integrator + "' (must be generalized_alpha)"});
  options.step = in.number("step", options.step);
  options.spectral_radius = in.number("spectral_radius", options.spectral_radius);
  in.finish();
  return options;
}

void loadAlarm(Reader in, monitor::AlarmConfig& alarm)
{
  const auto optional = [&](const char* key, std::optional<double>& value)
  {
    if (in.has(key))
      value = in.optionalNumber(key);
  };
  optional("warning", alarm.warning);
  optional("limit", alarm.limit);
  alarm.timing.on_delay = in.number("on_delay", alarm.timing.on_delay);
  alarm.timing.off_delay = in.number("off_delay", alarm.timing.off_delay);
  alarm.timing.deadband = in.number("deadband", alarm.timing.deadband);
  alarm.timing.latch = in.flag("latch", alarm.timing.latch);
  in.finish();
}

void loadMonitor(Reader in, monitor::Config& config)
{
  config.rate = in.number("rate", config.rate);
  config.pose_timeout = in.number("pose_timeout", config.pose_timeout);
  config.invalid_timeout = in.number("invalid_timeout", config.invalid_timeout);
  Reader alarms = in.child("alarms");
  loadAlarm(alarms.child("over_tension"), config.alarms.over_tension);
  loadAlarm(alarms.child("breaking"), config.alarms.breaking);
  loadAlarm(alarms.child("slack"), config.alarms.slack);
  loadAlarm(alarms.child("bend_radius"), config.alarms.bend_radius);
  loadAlarm(alarms.child("stale_input"), config.alarms.stale_input);
  alarms.finish();
  in.finish();
}
}  // namespace

monitor::Config loadConfig(const Value& tree, const std::string& where)
{
  Reader in(tree);
  monitor::Config config;
  config.world_frame = in.text("world_frame", config.world_frame);
  config.environment = loadEnvironment(in.child("environment"));
  loadTether(in.child("tether"), config);
  config.vessel = loadVessel(in.child("vessel"));
  loadVehicle(in.child("vehicle"), config);
  config.solver = loadSolver(in.child("solver"));
  loadMonitor(in.child("monitor"), config);
  in.notBuiltYet("winch");
  in.ignore("diagnostic_period");  // of diagnostic_updater
  in.finish();

  // A key that could not be read has its fault already; its bound is not worth a second one.
  std::vector<std::string> bounds = monitor::problems(config);
  bounds.erase(std::remove_if(bounds.begin(), bounds.end(),
                              [](const std::string& text) { return text.find(" = nan ") != std::string::npos; }),
               bounds.end());
  in.report(bounds);
  if (!in.faults().empty())
    throw ParamError(where, in.faults());
  return config;
}

}  // namespace tether_monitor::params
