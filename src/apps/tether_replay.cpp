#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>

#include "command_line.h"
#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/monitor/config/suspicious_values.h"
#include "tether_monitor/params/load_config.h"
#include "tether_monitor/replay/csv_replay.h"
#include "tether_monitor/ros/bag_replay.h"

namespace
{
constexpr int INTERRUPTED = 130;  // exit code, as the shell has it

struct Arguments
{
  std::string config, bag, ns, motion, out;
  std::optional<tether_monitor::replay::Parting> parting;
  double rate = 0.0;
  double shape_rate = 1.0;
  bool quiet = false;
  bool forecast = false;
};

volatile std::sig_atomic_t is_interrupted = 0;

void interrupt(int)
{
  is_interrupted = 1;
}

void showProgress(double share)
{
  static int shown = -1;
  const int percent = static_cast<int>(100.0 * share);
  if (percent == shown)
    return;
  shown = percent;
  std::fprintf(stderr, "\r[%-50.*s] %3d %%%s", 50, std::string(percent / 2, '#').c_str(), percent,
               share >= 1.0 ? "\n" : "");
}

tether_monitor::replay::VehicleColumns columnsOf(tether_monitor::monitor::VehicleMode mode)
{
  using tether_monitor::monitor::VehicleMode;
  using tether_monitor::replay::VehicleColumns;
  switch (mode)
  {
    case VehicleMode::FREE:
      return VehicleColumns::POSE;
    case VehicleMode::OBSERVED:
      return VehicleColumns::OBSERVED;
    case VehicleMode::TRACKED:
      break;
  }
  return VehicleColumns::NONE;
}

void replayCsv(const Arguments& arguments, const tether_monitor::replay::ReplayOptions& options,
               tether_monitor::replay::VehicleColumns columns, tether_monitor::monitor::TetherEstimator& estimator)
{
  using namespace tether_monitor;
  const bool are_measurements = estimator.vehicle().acceptsLateMeasurements();
  const files::CsvTable table =
      files::readCsv(arguments.motion, are_measurements ? files::MayBeEmpty(replay::mayBeEmpty) : nullptr);
  const replay::Motion motion(table, estimator.config().vehicle_mode);
  std::optional<replay::RecordedMeasurements> measurements;
  if (are_measurements)
    measurements.emplace(table);
  replay::ResultRecorder recorder(arguments.out, arguments.shape_rate, columns);
  if (arguments.forecast)
    recorder.addForecasts(estimator.config());
  if (measurements)
    replay::replayMeasurements(*measurements, motion, options, estimator, recorder);
  else
    replay::replayMotion(motion, options, estimator, recorder);
  recorder.finish(estimator, is_interrupted != 0);
}

void replay(const Arguments& arguments)
{
  using namespace tether_monitor;
  monitor::Config config = params::loadConfigFile(arguments.config);
  if (arguments.parting)
    config = replay::preparedToPart(std::move(config), *arguments.parting);
  for (const std::string& value : monitor::suspiciousValues(config))
    std::cerr << "warning: suspicious: " << value << "\n";
  monitor::TetherEstimator estimator(config);
  replay::ReplayOptions options;
  options.parting = arguments.parting;
  options.rate = arguments.rate;
  options.is_interrupted = [] { return is_interrupted != 0; };
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  if (!arguments.quiet && isatty(STDERR_FILENO))
    options.progress = showProgress;

  const replay::VehicleColumns columns = columnsOf(estimator.config().vehicle_mode);
  if (!arguments.motion.empty())
  {
    replayCsv(arguments, options, columns, estimator);
  }
  else
  {
    replay::ResultRecorder recorder(arguments.out, arguments.shape_rate, columns);
    if (arguments.forecast)
      recorder.addForecasts(estimator.config());
    for (const std::string& warning : replayBag(arguments.bag, arguments.ns, options, estimator, recorder))
      std::cerr << "warning: " << apps::printable(warning) << "\n";
    recorder.finish(estimator, is_interrupted != 0);
  }
  if (!arguments.quiet)
    std::cout << "wrote ends.csv, alarms.csv, summary.json" << (arguments.shape_rate > 0.0 ? " and shape.csv" : "")
              << " to " << arguments.out << "\n";
}
}  // namespace

int main(int argc, char** argv)
{
  namespace options = boost::program_options;
  using tether_monitor::apps::CommandLineError;
  tether_monitor::apps::CommandLine line(
      "tether_replay", "Runs the tether monitor over a recording as fast as it can; no ROS master is needed.");
  Arguments a;
  std::string parting;
  line.add()("config", options::value(&a.config)->required(), "YAML file with the parameter tree of the node")(
      "bag", options::value(&a.bag), "bag with vessel/pose, vehicle/pose and so on")(
      "ns", options::value(&a.ns), "namespace of the topics in the bag")(
      "motion", options::value(&a.motion), "CSV file with the motion of both bodies")(
      "out", options::value(&a.out)->required(), "folder for the results, made if needed")(
      "rate", options::value(&a.rate),
      "rows of ends.csv per second (default: the rows of the motion; 20 for bags)")(
      "part-at", options::value(&parting),
      "T,S: the tether parts at time T [s], S metres from the vessel; with --motion, modes tracked and free")(
      "shape-rate", options::value(&a.shape_rate)->default_value(a.shape_rate),
      "shapes in shape.csv per second, 0 for none")(
      "forecast", options::bool_switch(&a.forecast),
      "also forecast as the node does, into forecast.csv, and score that against what came, in summary.json")(
      "quiet", options::bool_switch(&a.quiet), "no progress bar and no closing line");
  return tether_monitor::apps::runProgram("tether_replay", line, argc, argv,
                                          [&]
                                          {
                                            line.exclude("bag", "motion");
                                            line.exclude("ns", "motion");
                                            if (a.bag.empty() && a.motion.empty())
                                              throw CommandLineError("--bag or --motion is required");
                                            line.exclude("part-at", "bag");
                                            if (line.has("part-at"))
                                            {
                                              const auto [t, s] =
                                                  tether_monitor::apps::twoNumbers("part-at", parting);
                                              a.parting = tether_monitor::replay::Parting{t, s};
                                            }
                                            if (line.has("rate"))
                                              tether_monitor::apps::checkPositive("rate", a.rate);
                                            tether_monitor::apps::checkNotNegative("shape-rate", a.shape_rate);
                                            replay(a);
                                            return is_interrupted != 0 ? INTERRUPTED : 0;
                                          });
}
