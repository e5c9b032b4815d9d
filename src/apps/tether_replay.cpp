#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <iostream>

#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/params/load_config.h"
#include "tether_monitor/replay/csv_replay.h"
#include "tether_monitor/ros/bag_replay.h"

namespace
{
struct Arguments
{
  std::string config, bag, ns, motion, out;
  double rate = 0.0;
  double shape_rate = 1.0;
  bool quiet = false;
};

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

tether_monitor::replay::VehicleColumns recordedVehicle(const tether_monitor::monitor::TetherEstimator& estimator)
{
  using tether_monitor::replay::VehicleColumns;
  if (estimator.isVehicleObserved())
    return VehicleColumns::OBSERVED;
  return estimator.isVehicleFree() ? VehicleColumns::POSE : VehicleColumns::NONE;
}

void replay(const Arguments& arguments)
{
  using namespace tether_monitor;
  monitor::TetherEstimator estimator(params::loadConfigFile(arguments.config));
  replay::ReplayOptions options;
  options.rate = arguments.rate;
  if (!arguments.quiet && isatty(STDERR_FILENO))
    options.progress = showProgress;

  if (!arguments.motion.empty())
  {
    const bool is_observed = estimator.isVehicleObserved();
    const files::CsvTable table =
        files::readCsv(arguments.motion, is_observed ? files::MayBeEmpty(replay::mayBeEmpty) : nullptr);
    const replay::Motion motion(table, estimator.config().vehicle_mode);
    std::optional<replay::RecordedMeasurements> measurements;
    if (is_observed)
      measurements.emplace(table);
    replay::ResultRecorder recorder(arguments.out, arguments.shape_rate, recordedVehicle(estimator));
    if (measurements)
      replay::replayMeasurements(*measurements, motion, options, estimator, recorder);
    else
      replay::replayMotion(motion, options, estimator, recorder);
    recorder.finish(estimator);
  }
  else
  {
    replay::ResultRecorder recorder(arguments.out, arguments.shape_rate, recordedVehicle(estimator));
    for (const std::string& warning : replayBag(arguments.bag, arguments.ns, options, estimator, recorder))
      std::cerr << "warning: " << warning << "\n";
    recorder.finish(estimator);
  }
  if (!arguments.quiet)
    std::cout << "wrote ends.csv, alarms.csv, summary.json" << (arguments.shape_rate > 0.0 ? " and shape.csv" : "")
              << " to " << arguments.out << "\n";
}
}  // namespace

int main(int argc, char** argv)
{
  CLI::App app("Runs the tether monitor over a recording as fast as it can; no ROS master is needed.");
  Arguments arguments;
  app.add_option("--config", arguments.config, "YAML file with the parameter tree of the node")->required();
  auto* bag = app.add_option("--bag", arguments.bag, "bag with vessel/pose, vehicle/pose and so on");
  app.add_option("--ns", arguments.ns, "namespace of the topics in the bag")->needs(bag);
  auto* motion = app.add_option("--motion", arguments.motion, "CSV file with the motion of both bodies");
  bag->excludes(motion);
  app.add_option("--out", arguments.out, "folder for the results, made if needed")->required();
  app.add_option("--rate", arguments.rate,
                 "rows of ends.csv per second (default: the rows of the motion; 20 for bags)")
      ->check(CLI::PositiveNumber);
  app.add_option("--shape-rate", arguments.shape_rate, "shapes in shape.csv per second, 0 for none")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_flag("--quiet", arguments.quiet, "no progress bar and no closing line");
  try
  {
    app.parse(argc, argv);
    if (arguments.bag.empty() && arguments.motion.empty())
      throw CLI::RequiredError("--bag or --motion");
  }
  catch (const CLI::ParseError& error)
  {
    return app.exit(error) == 0 ? 0 : 1;
  }
  try
  {
    replay(arguments);
  }
  catch (const std::exception& error)
  {
    std::cerr << "tether_replay: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
