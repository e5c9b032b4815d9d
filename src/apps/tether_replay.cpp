#include <iostream>
#include <optional>

#include "command_line.h"
#include "recording.h"
#include "tether_monitor/params/load_config.h"

namespace
{
struct Arguments
{
  std::string config;
  tether_monitor::apps::Recording recording;
  tether_monitor::apps::Results results;
  std::optional<tether_monitor::replay::Parting> parting;
  double rate = 0.0;
  bool quiet = false;
};

void replay(const Arguments& arguments)
{
  using namespace tether_monitor;
  monitor::Config config = apps::loadConfigFor(arguments.recording, arguments.config);
  if (arguments.parting)
    config = replay::preparedToPart(std::move(config), *arguments.parting);
  monitor::TetherEstimator estimator(config);
  replay::ReplayOptions options = apps::replayOptions(arguments.quiet);
  options.parting = arguments.parting;
  options.rate = arguments.rate;
  const apps::ReplayReport report =
      apps::replayRecording(arguments.recording, options, arguments.results, estimator);
  for (const std::string& warning : report.warnings)
    std::cerr << "warning: " << apps::printable(warning) << "\n";
  if (arguments.quiet)
    return;
  std::cout << "estimate: " << report.status << "\nwrote ";
  for (const std::string& file : report.files)
    std::cout << file << (&file == &report.files.back() ? "" : ", ");
  std::cout << " to " << arguments.results.folder << "\n";
}
}  // namespace

int main(int argc, char** argv)
{
  namespace options = boost::program_options;
  tether_monitor::apps::CommandLine line(
      "tether_replay", "Runs the tether monitor over a recording as fast as it can; no ROS master is needed.");
  Arguments a;
  std::string parting;
  line.add()("config", options::value(&a.config)->required(), "YAML file with the parameter tree of the node");
  tether_monitor::apps::addOptions(line, a.recording, a.results, a.quiet);
  line.add()("rate", options::value(&a.rate),
             "rows of ends.csv per second (default: the rows of the motion; 20 for bags)")(
      "part-at", options::value(&parting),
      "T,S: the tether parts at time T [s], S metres from the vessel; with --motion, modes tracked and free")(
      "shape-rate", options::value(&a.results.shape_rate)->default_value(a.results.shape_rate),
      "shapes in shape.csv per second, 0 for none")(
      "forecast", options::bool_switch(&a.results.forecast),
      "also forecast as the node does, into forecast.csv, and score that against what came, in summary.json");
  return tether_monitor::apps::runProgram(
      "tether_replay", line, argc, argv,
      [&]
      {
        tether_monitor::apps::checkRecording(line, a.recording);
        line.exclude("part-at", "bag");
        if (line.has("part-at"))
        {
          const auto [t, s] = tether_monitor::apps::twoNumbers("part-at", parting);
          a.parting = tether_monitor::replay::Parting{t, s};
        }
        if (line.has("rate"))
          tether_monitor::apps::checkPositive("rate", a.rate);
        tether_monitor::apps::checkNotNegative("shape-rate", a.results.shape_rate);
        replay(a);
        return tether_monitor::apps::isInterrupted() ? tether_monitor::apps::INTERRUPTED : 0;
      });
}
