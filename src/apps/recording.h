#pragma once

#include <string>
#include <vector>

#include "command_line.h"
#include "tether_monitor/replay/csv_replay.h"

namespace tether_monitor::apps
{
/// What a dive was recorded in: one of the two.
struct Recording
{
  std::string bag, ns;
  std::string motion;  ///< CSV file
};

/// Where the results go.
struct Results
{
  std::string folder;
  double shape_rate = 1.0;  ///< [Hz]; 0: no shapes.
  bool forecast = false;
};

/// Options of a program by which a recording is told; --out, where the results go, and --quiet with them.
void addOptions(CommandLine& line, Recording& recording, Results& results, bool& quiet);
/// @throws CommandLineError unless they tell one recording.
void checkRecording(const CommandLine& line, const Recording& recording);

/// The configuration in a YAML file; attachments that name a frame are placed by the transforms of a bag.
/// Suspicious values are told on stderr.
/// @throws as params::loadConfigFile().
monitor::Config loadConfigFor(const Recording& recording, const std::string& path);

/// For replays from the keyboard: an interrupt, or a request to end, ends them; progress as a bar on stderr,
/// unless quiet or nobody looks at it.
replay::ReplayOptions replayOptions(bool quiet);
bool isInterrupted();
constexpr int INTERRUPTED = 130;  ///< exit code, as the shell has it.

/// What a replay leaves for its user to read.
struct ReplayReport
{
  std::vector<std::string> warnings;
  std::vector<std::string> files;  ///< in the folder of the results.
  std::string status;              ///< see replay::ResultRecorder::statusText().
};

/**
 * Runs an estimator over a recording and writes the files of a replay.
 *
 * @throws  std::runtime_error naming what cannot be read or written.
 */
ReplayReport replayRecording(const Recording& recording, const replay::ReplayOptions& options,
                             const Results& results, monitor::TetherEstimator& estimator);

}  // namespace tether_monitor::apps
