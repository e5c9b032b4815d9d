#include "tether_monitor/params/load_environment.h"

#include <memory>

#include "tether_monitor/files/depth_grid_file.h"
#include "tether_monitor/params/load_waves.h"
#include "tether_monitor/params/yaml_file.h"

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
    fault.insert(0, "environment.");
  in.addErrors(faults);
  return faults.empty() ? core::CurrentProfile(samples) : core::CurrentProfile();
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
}  // namespace

void loadEnvironment(ParameterReader in, const std::string& folder, monitor::Config& config)
{
  core::Environment& sea = config.environment;
  sea.water_density = in.number("water_density", sea.water_density);
  sea.gravity = in.number("gravity", sea.gravity);
  sea.current = loadCurrent(in);
  sea.waves = loadWaves(in);
  config.uncertainty.current = in.number("current_stddev", config.uncertainty.current);
  config.inputs.air_pressure = in.number("air_pressure", config.inputs.air_pressure);
  sea.wind = in.vector("wind", sea.wind);
  if (in.has("seabed"))
    sea.seabed = loadSeabed(in.child("seabed"), folder);
  for (ParameterReader& entry : in.list("obstacles"))
    sea.obstacles.push_back(loadObstacle(entry));
  in.finish();
}

}  // namespace tether_monitor::params
