#include "recording.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <optional>

#include "tether_monitor/files/csv_table.h"
#include "tether_monitor/ros/bag_replay.h"

namespace tether_monitor::apps
{
namespace
{
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

// The files of a replay; nothing is made before the recording has been read.
class Recorder
{
 public:
  Recorder(const Results& results, const monitor::TetherEstimator& estimator)
    : recorder_(results.folder, results.shape_rate, columnsOf(estimator.config().vehicle_mode))
  {
    if (results.forecast)
      recorder_.addForecasts(estimator.config());
  }
  replay::ResultRecorder& operator*() { return recorder_; }

 private:
  replay::ResultRecorder recorder_;
};

void replayMotionFile(const std::string& path, const replay::ReplayOptions& options, const Results& results,
                      monitor::TetherEstimator& estimator)
{
  const bool are_measurements = estimator.vehicle().acceptsLateMeasurements();
  const files::CsvTable table =
      files::readCsv(path, are_measurements ? files::MayBeEmpty(replay::mayBeEmpty) : nullptr);
  const replay::Motion motion(table, estimator.config().vehicle_mode);
  std::optional<replay::RecordedMeasurements> measurements;
  if (are_measurements)
    measurements.emplace(table);
  Recorder recorder(results, estimator);
  if (measurements)
    replay::replayMeasurements(*measurements, motion, options, estimator, *recorder);
  else
    replay::replayMotion(motion, options, estimator, *recorder);
  (*recorder).finish(estimator, isInterrupted());
}
}  // namespace

std::vector<std::string> replayRecording(const Recording& recording, const replay::ReplayOptions& options,
                                         const Results& results, monitor::TetherEstimator& estimator)
{
  std::vector<std::string> warnings;
  if (!recording.motion.empty())
  {
    replayMotionFile(recording.motion, options, results, estimator);
    return warnings;
  }
  Recorder recorder(results, estimator);
  warnings = replayBag(recording.bag, recording.ns, options, estimator, *recorder);
  (*recorder).finish(estimator, isInterrupted());
  return warnings;
}

void noteInterrupts()
{
  std::signal(SIGINT, interrupt);
  std::signal(SIGTERM, interrupt);
}

bool isInterrupted()
{
  return is_interrupted != 0;
}

bool isWatched()
{
  return isatty(STDERR_FILENO) != 0;
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

}  // namespace tether_monitor::apps
