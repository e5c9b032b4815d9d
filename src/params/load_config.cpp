#include "tether_monitor/params/load_config.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "tether_monitor/monitor/alarms/alarm_quantities.h"
#include "tether_monitor/params/load_bodies.h"
#include "tether_monitor/params/load_environment.h"
#include "tether_monitor/params/load_inputs.h"
#include "tether_monitor/params/load_monitor.h"
#include "tether_monitor/params/load_tether.h"
#include "tether_monitor/params/yaml_file.h"

namespace tether_monitor::params
{
monitor::Config loadConfig(const Value& tree, const std::string& where, const std::string& folder)
{
  ParameterReader in(tree);
  monitor::Config config;
  config.world_frame = in.text("world_frame", config.world_frame);
  loadEnvironment(in.child("environment"), folder, config);
  loadTether(in.child("tether"), config);
  config.vessel = loadVessel(in.child("vessel"));
  loadVehicle(in.child("vehicle"), config);
  loadSolver(in.child("solver"), config);
  loadSensors(in, config.uncertainty);
  loadMonitor(in.child("monitor"), config);
  loadInputs(in, config.inputs);
  if (in.has("winch"))
    config.winch = loadWinch(in.child("winch"));
  in.ignore("simulation");         // of tether_sim_node
  in.ignore("diagnostic_period");  // of diagnostic_updater
  in.finish();

  // A key that could not be read has its fault already; its bound is not worth a second one.
  std::vector<std::string> bounds = monitor::validateWithAlarms(config);
  bounds.erase(std::remove_if(bounds.begin(), bounds.end(),
                              [](const std::string& text) { return text.find(" = nan ") != std::string::npos; }),
               bounds.end());
  in.addErrors(bounds);
  if (!in.errors().empty())
    throw ParameterError(where, in.errors());
  return config;
}

monitor::Config loadConfigFile(const std::string& path, const std::function<Value(Value)>& prepare)
{
  const Value tree = readYamlFile(path);
  return loadConfig(prepare ? prepare(tree) : tree, path, std::filesystem::path(path).parent_path().string());
}

}  // namespace tether_monitor::params
