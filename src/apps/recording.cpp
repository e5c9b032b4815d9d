#include "recording.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <iostream>
#include <optional>

#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/monitor/config/suspicious_values.h"
#include "tether_monitor/params/load_config.h"
#include "tether_monitor/ros/attachment_frames.h"
#include "tether_monitor/ros/bag_replay.h"

namespace tether_monitor::apps
{
namespace
{
constexpr double MOST = 0.5;  // of the rows

volatile std::sig_atomic_t is_interrupted = 0;

void interrupt(int)
{
  is_interrupted = 1;
}

replay::VehicleColumns columnsOf(monitor::VehicleMode mode)
{
  switch (mode)
  {
    case monitor::VehicleMode::FREE:
      return replay::VehicleColumns::POSE;
    case monitor::VehicleMode::OBSERVED:
      return replay::VehicleColumns::OBSERVED;
    case monitor::VehicleMode::TRACKED:
      break;
  }
  return replay::VehicleColumns::NONE;
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

// Makes the files of a replay, which `replay` fills; it returns warnings.
template <class Replay>
ReplayReport record(const Results& results, monitor::TetherEstimator& estimator, const Replay& replay)
{
  replay::ResultRecorder recorder(results.folder, results.shape_rate, columnsOf(estimator.config().vehicle_mode));
  if (results.forecast)
    recorder.addForecasts(estimator.config());
  ReplayReport report;
  report.warnings = replay(recorder);
  recorder.finish(estimator, isInterrupted());
  report.files = recorder.files();
  report.status = recorder.statusText();
  const char* const advice = "; each reason has a section in doc/troubleshooting.md";
  if (recorder.shareOf(monitor::Status::INVALID) > MOST)
    report.warnings.push_back("most of the time there is no estimate: " + report.status + advice);
  else if (recorder.shareOf(monitor::Status::DEGRADED) > MOST)
    report.warnings.push_back("most of the time the estimate is worth less than usual: " + report.status + advice);
  return report;
}

ReplayReport replayMotionFile(const std::string& path, const replay::ReplayOptions& options,
                              const Results& results, monitor::TetherEstimator& estimator)
{
  const bool are_measurements = estimator.vehicle().acceptsLateMeasurements();
  const files::CsvTable table =
      files::readCsv(path, are_measurements ? files::MayBeEmpty(replay::mayBeEmpty) : nullptr);
  const replay::Motion motion(table, estimator.config().vehicle_mode);
  std::optional<replay::RecordedMeasurements> measurements;
  if (are_measurements)
    measurements.emplace(table);
  return record(results, estimator,
                [&](replay::ResultRecorder& recorder)
                {
                  if (measurements)
                    replay::replayMeasurements(*measurements, motion, options, estimator, recorder);
                  else
                    replay::replayMotion(motion, options, estimator, recorder);
                  return std::vector<std::string>();
                });
}
}  // namespace

void addOptions(CommandLine& line, Recording& recording, Results& results, bool& quiet)
{
  namespace options = boost::program_options;
  line.add()("bag", options::value(&recording.bag), "bag with vessel/pose, vehicle/pose and so on")(
      "ns", options::value(&recording.ns), "namespace of the topics in the bag")(
      "motion", options::value(&recording.motion),
      "CSV file with the motion of both bodies, or measurements of it")(
      "out", options::value(&results.folder)->required(), "folder for the results, made if needed")(
      "quiet", options::bool_switch(&quiet), "no progress bar and no closing line");
}

void checkRecording(const CommandLine& line, const Recording& recording)
{
  line.exclude("bag", "motion");
  line.exclude("ns", "motion");
  if (recording.bag.empty() && recording.motion.empty())
    throw CommandLineError("--bag or --motion is required");
}

monitor::Config loadConfigFor(const Recording& recording, const std::string& path)
{
  const auto placed = [&](const params::Value& tree)
  { return recording.bag.empty() ? tree : withPlacedAttachments(tree, path, recording.bag); };
  monitor::Config config = params::loadConfigFile(path, placed);
  for (const std::string& value : monitor::suspiciousValues(config))
    std::cerr << "warning: suspicious: " << value << "\n";
  return config;
}

replay::ReplayOptions replayOptions(bool quiet)
{
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
  replay::ReplayOptions options;
  options.is_interrupted = isInterrupted;
  if (!quiet && isatty(STDERR_FILENO))
    options.progress = showProgress;
  return options;
}

bool isInterrupted()
{
  return is_interrupted != 0;
}

ReplayReport replayRecording(const Recording& recording, const replay::ReplayOptions& options,
                             const Results& results, monitor::TetherEstimator& estimator)
{
  if (!recording.motion.empty())
    return replayMotionFile(recording.motion, options, results, estimator);
  return record(results, estimator,
                [&](replay::ResultRecorder& recorder)
                { return replayBag(recording.bag, recording.ns, options, estimator, recorder); });
}

}  // namespace tether_monitor::apps
