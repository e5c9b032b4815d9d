#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>

#include "command_line.h"
#include "recording.h"
#include "tether_monitor/params/identified_configuration.h"
#include "tether_monitor/params/load_config.h"

namespace
{
using namespace tether_monitor;

struct Arguments
{
  std::string config;
  apps::Recording recording;
  apps::Results results;
  int passes = 3;
  bool quiet = false;
};

void print(const monitor::Identification& found)
{
  std::printf("%-24s %22s %22s\n", "", "configured", "identified");
  for (const monitor::ParameterEstimate& e : found.parameters)
  {
    const char* remark = !e.isTold()                  ? "the record does not tell"
                         : std::abs(e.surprise()) > 2 ? "far from what is configured"
                                                      : "";
    std::printf("%-24s %10.4g +- %-8.3g %10.4g +- %-8.3g %s\n", e.name.c_str(), e.configured, e.configured_stddev,
                e.mean, e.stddev, remark);
  }
  std::printf("after %d passes%s\n", found.passes,
              found.has_settled ? "" : "; the last one still changed something: try more");
}

void write(const std::string& path, const std::string& text)
{
  std::ofstream out(path);
  out << text;
  out.close();
  if (!out)
    throw std::runtime_error("cannot write " + path);
}

int identify(const Arguments& arguments)
{
  const monitor::Config config = apps::loadConfigFor(arguments.recording, arguments.config);
  if (config.vehicle_mode != monitor::VehicleMode::OBSERVED)
    throw std::runtime_error(arguments.config + ": vehicle.mode must be observed to identify a tether");
  const replay::ReplayOptions options = apps::replayOptions(arguments.quiet);
  bool length_is_counted = false;
  int pass = 0;
  const auto run = [&](const monitor::Config& tried) -> std::optional<std::vector<monitor::ParameterEstimate>>
  {
    monitor::TetherEstimator estimator(tried);
    for (const std::string& warning :
         apps::replayRecording(arguments.recording, options, arguments.results, estimator).warnings)
      if (pass == 0)
        std::cerr << "warning: " << apps::printable(warning) << "\n";
    ++pass;
    length_is_counted = !std::isnan(estimator.estimate().payout_age);
    if (apps::isInterrupted() || !estimator.isRunning())
      return std::nullopt;
    return estimator.parameters();
  };
  const monitor::Identification found = monitor::identify(config, run, arguments.passes);
  if (apps::isInterrupted())
    return apps::INTERRUPTED;
  if (found.parameters.empty())
    throw std::runtime_error("the record ends without an estimate: see status and reason in " +
                             arguments.results.folder + "/ends.csv and summary.json");
  const std::string path = arguments.results.folder + "/identified.yaml";
  write(path, params::identifiedConfiguration(arguments.config, config, found, length_is_counted));
  print(found);
  if (!arguments.quiet)
    std::cout << "wrote " << path << " beside the files of the last pass\n";
  return 0;
}
}  // namespace

int main(int argc, char** argv)
{
  namespace options = boost::program_options;
  apps::CommandLine line(
      "tether_identify",
      "Finds drag, weight and length of a tether, the drag of its vehicle and the current from a "
      "recorded dive.");
  Arguments a;
  line.add()("config", options::value(&a.config)->required(),
             "YAML file with the parameter tree of the node, mode observed")(
      "passes", options::value(&a.passes)->default_value(a.passes), "over the record, at most");
  apps::addOptions(line, a.recording, a.results, a.quiet);
  return apps::runProgram("tether_identify", line, argc, argv,
                          [&]
                          {
                            apps::checkRecording(line, a.recording);
                            apps::checkPositive("passes", a.passes);
                            return identify(a);
                          });
}
