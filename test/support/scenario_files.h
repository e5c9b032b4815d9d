#pragma once

#include <string>

#include "tether_monitor/params/load_config.h"
#include "tether_monitor/params/load_simulation.h"
#include "tether_monitor/params/yaml_file.h"
#include "tether_monitor/simulation/simulator.h"

namespace tether_monitor::simulation
{
/// One of the scenarios that are shipped.
struct ScenarioFile
{
  explicit ScenarioFile(const std::string& name)
    : tree(params::readYamlFile(PROJECT_DIR "/config/scenarios/" + name + ".yaml")),
      config(params::loadConfig(tree, name)),
      simulation(params::loadSimulation(tree, name))
  {
  }

  params::Value tree;
  monitor::Config config;
  SimulationConfig simulation;
};
}  // namespace tether_monitor::simulation
