#include "tether_monitor/params/load_config.h"

#include <algorithm>
#include <filesystem>
#include <memory>

#include "tether_monitor/files/depth_grid_file.h"
#include "tether_monitor/params/parameter_reader.h"
#include "tether_monitor/params/yaml_file.h"

#include "tether_monitor/core/solve/mesh_convergence.h"

namespace tether_monitor::params
{
namespace
{
core::CurrentProfile loadCurrent(ParameterReader& in)
{
  std::vector<core::CurrentProfile::Sample> samples;
  for (ParameterReader& entry : in.list("current"))
  {
    samples.push_back({entry.number("depth"), entry.vector("velocity")});
    entry.finish();
  }
  std::vector<std::string> faults = core::validate(samples);
  for (std::string& fault : faults)
    fault = "environment." + fault;
  in.addErrors(faults);
  return faults.empty() ? core::CurrentProfile(samples) : core::CurrentProfile();
}

core::WaveProperties loadWaves(ParameterReader in)
{
  core::WaveProperties waves;
  waves.amplitude = in.number("amplitude", waves.amplitude);
  waves.length = in.number("length", waves.length);
  waves.direction = in.number("direction", waves.direction);
  waves.phase = in.number("phase", waves.phase);
  in.finish();
  return waves;
}

core::Seabed loadSeabed(ParameterReader in, const std::string& folder)
{
  core::Seabed seabed;
  seabed.depth = in.number("depth", seabed.depth);
  const core::Vector3 slope = in.vector2("slope", core::Vector3::Zero());
  seabed.slope = slope.head<2>();
  seabed.normal_stiffness = in.number("normal_stiffness", seabed.normal_stiffness);
  seabed.damping = in.number("damping", seabed.damping);
  seabed.friction = in.number("friction", seabed.friction);
  const std::string grid = in.text("grid", "");
  if (!grid.empty())
  {
    try
    {
      seabed.grid = std::make_shared<const core::DepthGrid>(files::readDepthGrid(files::fileBeside(folder, grid)));
    }
    catch (const std::exception& error)
    {
      in.addErrors({std::string("environment.seabed.grid: ") + error.what()});
    }
  }
  in.finish();
  return seabed;
}

core::ObstacleShape loadShape(ParameterReader& in)
{
  // As a word, or as the number of Obstacle.msg.
  const std::string word = in.textOrInteger("shape");
  if (word == "sphere" || word == "SPHERE" || word == "0")
    return core::ObstacleShape::SPHERE;
  if (word == "cylinder" || word == "CYLINDER" || word == "1")
    return core::ObstacleShape::CYLINDER;
  if (!word.empty() && word != "box" && word != "BOX" && word != "2")
    in.addError("shape", " = '" + word + "' (must be sphere, cylinder or box)");
  return core::ObstacleShape::BOX;
}

core::Obstacle loadObstacle(ParameterReader in)
{
  core::Obstacle obstacle;
  obstacle.name = in.text("name", "");
  obstacle.shape = loadShape(in);
  ParameterReader pose = in.child("pose");
  obstacle.position = pose.vector("position");
  const std::vector<double> q = pose.numbers("orientation", {0.0, 0.0, 0.0, 1.0}, 4, 4);
  obstacle.orientation = Eigen::Quaterniond(q[3], q[0], q[1], q[2]);
  pose.finish();
  const std::size_t sizes = static_cast<std::size_t>(obstacle.shape) + 1;
  const std::vector<double> size = in.numbers("size", {}, sizes, sizes);
  for (std::size_t i = 0; i < size.size(); ++i)
    obstacle.size[static_cast<int>(i)] = size[i];
  obstacle.velocity = in.vector("velocity", obstacle.velocity);
  obstacle.mass = in.number("mass", obstacle.mass);
  obstacle.friction = in.number("friction", obstacle.friction);
  obstacle.stiffness = in.number("stiffness", obstacle.stiffness);
  in.finish();
  return obstacle;
}

core::Environment loadEnvironment(ParameterReader in, const std::string& folder)
{
  core::Environment sea;
  sea.water_density = in.number("water_density", sea.water_density);
  sea.gravity = in.number("gravity", sea.gravity);
  sea.current = loadCurrent(in);
  sea.waves = loadWaves(in.child("waves"));
  sea.wind = in.vector("wind", sea.wind);
  if (in.has("seabed"))
    sea.seabed = loadSeabed(in.child("seabed"), folder);
  for (ParameterReader& entry : in.list("obstacles"))
    sea.obstacles.push_back(loadObstacle(entry));
  in.finish();
  return sea;
}

// The properties from `diameter` on: of the tether, or of a section that differs from it where it says so.
void loadProperties(ParameterReader& in, const core::CableProperties* base, core::CableProperties& p)
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
  p.hydrostatic_compression = in.number("hydrostatic_compression", p.hydrostatic_compression);
  p.permanent_elongation = in.number("permanent_elongation", p.permanent_elongation);
}

core::CableLayout loadFittings(ParameterReader& in, const core::CableProperties& tether)
{
  core::CableLayout layout;
  for (ParameterReader& entry : in.list("sections"))
  {
    core::CableSection section;
    section.from = entry.number("from");
    section.to = entry.number("to");
    section.properties = tether;
    loadProperties(entry, &tether, section.properties);
    if (entry.has("min_bend_radius"))
      section.properties.min_bend_radius = entry.optionalNumber("min_bend_radius");
    entry.finish();
    layout.sections.push_back(section);
  }
  for (ParameterReader& entry : in.list("attachments"))
  {
    core::Attachment attachment;
    attachment.name = entry.text("name", "");
    attachment.s = entry.number("s");
    attachment.mass = entry.number("mass");
    attachment.volume = entry.number("volume");
    attachment.drag_area = entry.number("drag_area", 0.0);
    entry.finish();
    layout.attachments.push_back(attachment);
  }
  return layout;
}

void loadTether(ParameterReader in, monitor::Config& config)
{
  core::CableProperties& p = config.tether;
  p.length = in.number("length");
  if (in.isText("elements", "auto"))
    config.accuracy = in.number("accuracy", 1e-3);
  else
    config.elements = in.integer("elements");
  if (!config.accuracy && in.has("accuracy"))
  {
    in.addError("accuracy", " is for elements: auto");
    in.ignore("accuracy");
  }
  loadProperties(in, nullptr, p);
  p.min_bend_radius = in.optionalNumber("min_bend_radius");
  config.drag_amplification = in.number("drag_amplification", config.drag_amplification);
  config.layout = loadFittings(in, p);
  // With elements: auto a mesh to begin with, that has room for what is fixed to the tether.
  while (config.accuracy && config.elements < core::MOST_ELEMENTS &&
         !core::validateElementCount(config.elements, p.length, config.layout).empty())
    ++config.elements;
  in.finish();
}

monitor::BodyConfig loadBody(ParameterReader& in)
{
  monitor::BodyConfig body;
  body.attachment = in.vector("attachment", body.attachment);
  body.frame = in.text("frame", body.frame);
  return body;
}

monitor::BodyConfig loadVessel(ParameterReader in)
{
  monitor::BodyConfig body = loadBody(in);
  if (in.has("position_stddev"))
    body.position_stddev = in.optionalNumber("position_stddev");
  if (in.has("velocity_stddev"))
    body.velocity_stddev = in.optionalNumber("velocity_stddev");
  in.finish();
  return body;
}

std::optional<core::WinchProperties> loadWinch(ParameterReader in)
{
  core::WinchProperties winch;
  winch.core_diameter = in.number("core_diameter");
  winch.width = in.number("width");
  winch.layers = in.integer("layers");
  in.finish();
  return winch;
}

monitor::NavigationConfig loadNavigation(ParameterReader& in)
{
  monitor::NavigationConfig navigation;
  navigation.position_stddev = in.number("position_stddev", navigation.position_stddev);
  navigation.velocity_stddev = in.number("velocity_stddev", navigation.velocity_stddev);
  navigation.latency = in.number("latency", navigation.latency);
  if (in.has("force_stddev"))
    navigation.force_stddev = in.optionalNumber("force_stddev");
  navigation.drag_stddev = in.number("drag_stddev", navigation.drag_stddev);
  return navigation;
}

void loadVehicle(ParameterReader in, monitor::Config& config)
{
  config.vehicle = loadBody(in);
  const std::string mode = in.text("mode", "tracked");
  const bool is_simulated = mode == "free" || mode == "observed";
  if (is_simulated)
  {
    config.vehicle_mode = mode == "free" ? monitor::VehicleMode::FREE : monitor::VehicleMode::OBSERVED;
    config.vehicle_body = loadRigidBody(in);
  }
  // A file that was written for another mode stays good.
  if (mode == "observed")
    config.navigation = loadNavigation(in);
  else
    for (const char* key : {"position_stddev", "velocity_stddev", "latency", "force_stddev", "drag_stddev"})
      in.ignore(key);
  if (mode == "tracked")
  {
    for (const char* key : {"mass", "volume", "inertia", "drag_area", "added_mass", "added_inertia",
                            "rotational_drag", "center_of_buoyancy", "force"})
      in.ignore(key);
  }
  else if (!is_simulated)
  {
    in.addErrors({"vehicle.mode = '" + mode + "' (must be tracked, free or observed)"});
  }
  in.finish();
}

core::StepperOptions loadSolver(ParameterReader in)
{
  core::StepperOptions options;
  const std::string integrator = in.text("integrator", "generalized_alpha");
  if (integrator == "abarbanel_zwas")
    options.scheme = core::Scheme::ABARBANEL_ZWAS;
  else if (integrator != "generalized_alpha")
    in.addErrors({"solver.integrator = '" + integrator + "' (must be generalized_alpha or abarbanel_zwas)"});
  options.corrections = in.integer("corrections", options.corrections);
  options.courant = in.number("courant", options.courant);
  options.step = in.number("step", options.step);
  options.spectral_radius = in.number("spectral_radius", options.spectral_radius);
  in.finish();
  return options;
}

void loadAlarm(ParameterReader in, monitor::AlarmConfig& alarm)
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
  alarm.timing.latch = in.boolean("latch", alarm.timing.latch);
  in.finish();
}

void loadMonitor(ParameterReader in, monitor::Config& config)
{
  config.rate = in.number("rate", config.rate);
  config.pose_timeout = in.number("pose_timeout", config.pose_timeout);
  config.invalid_timeout = in.number("invalid_timeout", config.invalid_timeout);
  config.navigation.degraded_stddev = in.number("degraded_stddev", config.navigation.degraded_stddev);
  config.navigation.invalid_stddev = in.number("invalid_stddev", config.navigation.invalid_stddev);
  ParameterReader alarms = in.child("alarms");
  loadAlarm(alarms.child("over_tension"), config.alarms.over_tension);
  loadAlarm(alarms.child("breaking"), config.alarms.breaking);
  loadAlarm(alarms.child("slack"), config.alarms.slack);
  loadAlarm(alarms.child("bend_radius"), config.alarms.bend_radius);
  loadAlarm(alarms.child("stale_input"), config.alarms.stale_input);
  alarms.finish();
  in.finish();
}
}  // namespace

core::RigidBody loadRigidBody(ParameterReader& in)
{
  core::RigidBody body;
  body.mass = in.number("mass");
  body.volume = in.number("volume");
  body.inertia = in.vector("inertia");
  body.drag_area = in.vector("drag_area");
  body.added_mass = in.vector("added_mass", body.added_mass);
  body.added_inertia = in.vector("added_inertia", body.added_inertia);
  body.rotational_drag = in.vector("rotational_drag", body.rotational_drag);
  body.center_of_buoyancy = in.vector("center_of_buoyancy", body.center_of_buoyancy);
  body.force = in.vector("force", body.force);
  return body;
}

monitor::Config loadConfig(const Value& tree, const std::string& where, const std::string& folder)
{
  ParameterReader in(tree);
  monitor::Config config;
  config.world_frame = in.text("world_frame", config.world_frame);
  config.environment = loadEnvironment(in.child("environment"), folder);
  loadTether(in.child("tether"), config);
  config.vessel = loadVessel(in.child("vessel"));
  loadVehicle(in.child("vehicle"), config);
  config.solver = loadSolver(in.child("solver"));
  loadMonitor(in.child("monitor"), config);
  if (in.has("winch"))
    config.winch = loadWinch(in.child("winch"));
  in.ignore("simulation");         // of tether_sim_node
  in.ignore("diagnostic_period");  // of diagnostic_updater
  in.finish();

  // A key that could not be read has its fault already; its bound is not worth a second one.
  std::vector<std::string> bounds = monitor::validate(config);
  bounds.erase(std::remove_if(bounds.begin(), bounds.end(),
                              [](const std::string& text) { return text.find(" = nan ") != std::string::npos; }),
               bounds.end());
  in.addErrors(bounds);
  if (!in.errors().empty())
    throw ParameterError(where, in.errors());
  return config;
}

monitor::Config loadConfigFile(const std::string& path)
{
  return loadConfig(readYamlFile(path), path, std::filesystem::path(path).parent_path().string());
}

}  // namespace tether_monitor::params
